// What the shadow of a box can reach: the convex body of the points whose segment to the light
// meets the box.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/mesh.h"
#include "shadow/view_frustum.h"

namespace shadowlab::shadow {

/// A parallelepiped, world space: the points center + Σ t_k · half[k], t_k in [-1, 1].
struct Crate {
  glm::dvec3 center{0};
  std::array<glm::dvec3, 3> half;

  /// Corner i lies at +half[k] where bit k of i is set.
  glm::dvec3 corner(std::size_t i) const {
    return center + ((i & 1) ? half[0] : -half[0]) + ((i & 2) ? half[1] : -half[1]) +
           ((i & 4) ? half[2] : -half[2]);
  }
};

/// Holds every point that is at most `room` > 0 metres from `bounds` (not empty) under `model`: the
/// box as the model turns it, or, where the model flattens it, the axis-aligned one.
Crate crate_around(const scene::Bounds& bounds, const glm::dmat4& model, double room);

/// The same as corners and planes.
Hexahedron hexahedron(const Crate& crate);

/// A point is inside where it is on the positive side of all planes (a, b, c, d); none: everywhere.
class ShadowReach {
 public:
  /// Of a caster in `crate`; `light` in world space, w ≥ 0. Holds all of the crate, of its shadow
  /// and of its shadow volume. Everything, where the light is inside the crate. Its sides stand on
  /// edges of the crate: planes are proposed by every edge and every face, and those kept that the
  /// crate and the directions of its shadow are behind.
  ShadowReach(const Crate& crate, glm::dvec4 light);

  std::span<const glm::dvec4> planes() const { return {planes_.data(), count_}; }

  /// Whether one of the planes has all of `crate` behind it: then they do not meet.
  bool parts_from(const Crate& crate) const;
  /// Whether all of `crate` is inside.
  bool holds(const Crate& crate) const;
  /// What of a convex polygon is inside: valid until `scratch` is used again.
  std::span<const glm::dvec3> inside(std::span<const glm::dvec3> polygon,
                                     ClipScratch& scratch) const {
    return clipped(polygon, planes(), scratch);
  }

 private:
  void propose(glm::dvec3 normal, std::span<const glm::dvec3, 8> corners,
               std::span<const glm::dvec3, 8> away);
  std::array<glm::dvec4, 30> planes_;  // 6 faces, 12 edges either way
  std::size_t count_ = 0;
};

}  // namespace shadowlab::shadow
