// What the camera sees of the boxes of a scene, and what a shadow's reach meets of that: what the
// plans of volumes (shadow/plan.h) and of maps (shadow/map_needs.h) are made from.
//
// What boxes hide, those meshes that are boxes, is not seen. Boxes grow by what GL's arithmetic may
// move a surface: floats, corners at 1/256 of a pixel, depth of 24 bits and the volumes' offset.
// The far plane is at infinity.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shadow/occlusion.h"
#include "shadow/reach.h"
#include "shadow/view_frustum.h"

namespace shadowlab::shadow {

/// The view's axes and scales, in which depths, pixels and their tolerances are told.
struct Eye {
  Eye(const scene::Camera& camera, glm::ivec2 picture);

  double depth(glm::dvec3 point) const { return -(view * glm::dvec4(point, 1)).z; }
  double area() const { return size.x * size.y; }
  glm::dvec2 pixel(glm::dvec3 point) const;
  /// How far GL may move a surface at this depth against the volumes: 1/32 of a pixel (corners are
  /// at 1/256, and the offset of a slope is 1/512) and twelve steps of 24-bit depth (the offset is
  /// two, and each depth is off by up to five: scripts/parts/scene_depth.lua).
  double tolerance(double depth) const;

  glm::dvec3 position;
  glm::dmat4 view;
  glm::dvec2 size;  ///< pixels
  double slope, aspect, near;
};

/// An object's box, and what of its surface the camera sees.
struct Body {
  scene::Bounds bounds;  ///< model space; empty where the object has no vertex
  double room = 0;       ///< that the crate is grown by, metres
  Crate crate;
  double farthest = 0;        ///< depth
  std::vector<Polygon> seen;  ///< of the surface of what it has in common with the view
  Extent extent;              ///< of what is seen
  bool shadowed = false;      ///< whether met_by found a shadow on it
  bool whole_box = false;     ///< the mesh is its box, and the near plane does not cut it
  bool hides_back = false;    ///< as shadow/back.h has it
  /// Of a mesh that is its box, world space: bit k set where axis k is at its high end.
  std::array<glm::dvec3, 8> corners{};
};

class Sight {
 public:
  /// Errors as Camera::view and Camera::projection. `picture` in pixels.
  Sight(const scene::Scene& scene, const scene::Camera& camera, glm::ivec2 picture);

  const Eye& eye() const { return eye_; }
  /// In the scene's order.
  const std::vector<Body>& bodies() const { return bodies_; }

  /// From here on only what is seen between these distances along the view counts, where they are
  /// given, and only of bodies that `wanted`, given their crates, wants.
  void narrow(const std::optional<DepthRange>& part,
              const std::function<bool(const Crate&)>& wanted);

  /// Of a box that hides its back, whether it may show a side that is turned from the light, and
  /// all but surely so; nothing where that cannot be told from here: of a body that is no such box,
  /// and of one with a side so edge on to the eye or to the light that rounding may turn it round.
  std::optional<bool> shows_unlit_side(std::size_t caster, glm::dvec4 light) const;

  enum class Itself { met, left_out };
  /// Where the reach of the shadow of a body meets a box that is seen, its own too where that is
  /// not left out; marks those boxes as shadowed.
  Extent met_by(const ShadowReach& reach, std::size_t caster, Itself itself);
  /// Marks the body's own box as shadowed, and says where it is seen.
  Extent met_itself(std::size_t caster);
  /// Whether it meets one.
  bool is_met_by(const ShadowReach& reach, const Crate& caster);
  /// What of the view the reach of a body covers, met or not; empty where it does not enter it.
  Extent covered_by(const ShadowReach& reach, std::size_t caster);

 private:
  void sort_seen();

  scene::Camera camera_;
  Eye eye_;
  std::vector<Body> bodies_;
  std::optional<Hexahedron> view_;
  std::array<Polygon, 6> view_sides_;       // where there is a view
  std::optional<Occlusion> occlusion_;      // where there is a view
  std::vector<std::size_t> largest_first_;  // of what is seen
  Extent all_seen_;
  std::size_t unshadowed_ = 0;  // of them
  ClipScratch scratch_;
};

/// The pixels of an extent, one more around, as far as they are in a picture of `size`: low corner
/// and beyond the high one.
struct PixelSpan {
  glm::ivec2 first{0}, last{0};
};
PixelSpan pixels_of(const Extent& extent, glm::dvec2 size);

}  // namespace shadowlab::shadow
