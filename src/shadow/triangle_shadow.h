// The shadow of a single triangle, as the planes around it.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// What a triangle shadows is bounded by four planes: its own, and one through each edge and the
/// light. A plane (n, d), |n| = 1, has the point p on its positive side where n·p + d > 0. The
/// triangle shadows p where
///
///   own·p < 0   (on the other side of it than the light)   and   edge_i·p >= 0  for all three.
///
/// Nothing of it is projected, so a triangle may reach behind the light. (E. Sintorn, O. Olsson,
/// U. Assarsson, An Efficient Alias-free Shadow Algorithm for Opaque and Transparent Objects using
/// per-triangle Shadow Volumes, SIGGRAPH Asia 2011.)
///
/// Invariant: triangles that share an edge have the same numbers for its plane but for the sign, if
/// that. So no point slips between them. All are zero for a triangle without area or whose plane
/// holds the light, as far as a double's rounding tells: it shadows nothing.
struct TriangleShadow {
  glm::dvec4 own{0};
  std::array<glm::dvec4, 3> edges{};
};

/// `light` is the origin's own place (w = 1; xyz is not read), or the direction toward a light at
/// infinity (w = 0): corners are relative to a point light.
TriangleShadow triangle_shadow(const std::array<glm::dvec3, 3>& corners, glm::dvec4 light);

}  // namespace shadowlab::shadow
