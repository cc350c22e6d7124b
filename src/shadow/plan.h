// What a frame of shadow volumes needs, found from boxes alone, so that the rest is neither built
// nor drawn. The picture stays the same, pixel for pixel: what is left out would have counted zero
// at every pixel that the scene covers.
//
//  - What boxes hide, those meshes that are boxes, is not seen.
//  - A caster whose shadow meets no box of the scene that the camera sees is dropped. (A caster
//    that is seen itself meets its own. But a box that hides its back shadows nothing of itself
//    than its own sides that are turned from the light, and which those are is known without a
//    volume: so it needs one for others alone, and none of this where all its seen sides are lit.)
//  - Of the others, z-fail and its caps only where z-pass would be wrong (shadow/zfail.h).
//  - Each volume counts only where its shadow meets such a box: inside the pixels that the scissor
//    leaves.
//
// What boxes are and how they are seen: shadow/sight.h. Maps: shadow/map_needs.h.
//
// Sources: D. Lloyd, J. Wendt, N. Govindaraju, D. Manocha, CC Shadow Volumes, 2004 (casters culled
// by potential receivers); M. McGuire et al., Fast, Practical and Robust Shadows, 2003 (volumes
// outside the view, z-pass or z-fail for each, scissor by bounds).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shadow/sight.h"
#include "shadow/zfail.h"

namespace shadowlab::shadow {

/// Pixels from (x, y) on, as glScissor counts them: from the picture's lower left corner.
struct PixelRectangle {
  int x = 0, y = 0, width = 0, height = 0;
  std::int64_t area() const { return std::int64_t{width} * height; }
  friend bool operator==(const PixelRectangle&, const PixelRectangle&) = default;
};

struct Plan {
  /// Objects by their index in the scene, in its order.
  struct Kept {
    std::size_t object;
    /// From the near pyramid: z-pass is right; else z-fail, if there is a volume.
    std::optional<Parting> apart;
    /// Outside of it the volume counts zero, its own unlit sides aside; without pixels where the
    /// volume is needed nowhere.
    PixelRectangle scissor;
    bool unlit;  ///< it may be seen from a side that is turned from the light
  };
  enum class Why {
    outside_view,   ///< neither the caster nor its shadow is in the camera's view
    meets_nothing,  ///< they enter the view, but meet no box that is seen there
    all_lit,        ///< only sides of its own that the light reaches are met
  };
  struct Dropped {
    std::size_t object;
    Why why;
    PixelRectangle covered;  ///< holds what of the picture its volume covers, where it counts zero
  };
  std::vector<Kept> casters;
  std::vector<Dropped> dropped;
  std::vector<std::size_t> seen;      ///< objects whose box the camera may see
  std::vector<std::size_t> shadowed;  ///< those of them that a shadow may reach, their own too
  PixelRectangle shadows;             ///< where
};

/// Without reasons, what is dropped has all_lit or meets_nothing, and covers nothing: it is
/// quicker.
enum class Reasons { none, told };

/// `light` in world space, w = 0 or w > 0, a point or a direction. `picture` in pixels. Throws
/// InputError as Camera::view, Camera::projection, normalized_light and for a caster whose model
/// matrix is singular.
Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
          glm::ivec2 picture, Reasons reasons = Reasons::told);
/// The same of what this camera sees of this scene.
Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light, Sight sight,
          Reasons reasons = Reasons::told);

}  // namespace shadowlab::shadow
