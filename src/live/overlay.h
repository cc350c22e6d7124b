// Lines and faces of the subject over the scene: silhouettes, volumes, what the light sees.
//
// They are drawn over the shown picture and never into it.
#pragma once

#include <memory>
#include <vector>

#include "live/orbit.h"

namespace shadowlab::live {

enum class Overlay { none, silhouettes, volumes, frustum, cascades, count };
const char* name_of(Overlay overlay);

/// A closed face, or the open line through its points. World space.
struct Shape {
  enum class Kind { line, face };
  Kind kind = Kind::line;
  std::vector<glm::dvec3> points;
  int group = 0;  ///< of one colour: which cascade
};

/// Empty where the overlay has nothing to show for this light.
std::vector<Shape> shapes(Overlay overlay, const scene::Scene& scene, const scene::Camera& camera,
                          double aspect, glm::dvec4 light);

/// The same, computed anew only where something that it is made of has changed: it takes longer
/// than many a frame.
class OverlayShapes {
 public:
  const std::vector<Shape>& of(Overlay overlay, const scene::Scene& scene,
                               const scene::Camera& camera, double aspect, glm::dvec4 light);

 private:
  struct MadeOf {
    Overlay overlay = Overlay::none;
    std::vector<double> numbers;                             ///< of camera, light and objects
    std::vector<std::shared_ptr<const scene::Mesh>> meshes;  ///< held: no other is where one was
    bool operator==(const MadeOf&) const = default;
  };
  MadeOf made_of_;
  std::vector<Shape> shapes_;
};

/// The part of the shape before the camera's near plane, in the picture: x and y as in Seen.
/// Empty where there is none.
std::vector<glm::dvec2> projected(const Shape& shape, const scene::Camera& camera, double aspect);

}  // namespace shadowlab::live
