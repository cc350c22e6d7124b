// What a camera can see of boxes: the convex pieces that shadow maps are fitted to.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {

/// Planes (a, b, c, d), a point v inside where a v.x + b v.y + c v.z + d >= 0 for all.
using Planes = std::array<glm::dvec4, 6>;

/// A convex polygon's corners, in order around it.
using Polygon = std::vector<glm::dvec3>;

/// A box with six flat sides, not necessarily rectangular: a camera's frustum, or Bounds.
struct Hexahedron {
  std::array<glm::dvec3, 8> corners;  ///< bit 0: x, bit 1: y, bit 2: z (near 0, far 1)
  Planes planes;
};

/// The camera's frustum between the distances `near` and `far`, world space. Errors as
/// Camera::view and Camera::projection.
Hexahedron frustum(const scene::Camera& camera, double aspect, double near, double far);

Hexahedron hexahedron(const scene::Bounds& box);

/// Its six sides, each a polygon of four corners in order around it.
std::array<Polygon, 6> sides_of(const Hexahedron& shape);

/// The surface of what two hexahedra have in common; nothing where they are disjoint. (Sides of
/// each clipped by the planes of the other: Sutherland and Hodgman 1974.)
std::vector<Polygon> common_sides(const Hexahedron& a, const Hexahedron& b);

/// What of a convex polygon is on the positive side of `plane`.
Polygon clipped(std::span<const glm::dvec3> polygon, glm::dvec4 plane);

/// What of it is on the positive side of all `planes`, as `clipped`, without its allocations: valid
/// until `scratch` is used again.
struct ClipScratch {
  Polygon now, next;
};
std::span<const glm::dvec3> clipped(std::span<const glm::dvec3> polygon,
                                    std::span<const glm::dvec4> planes, ClipScratch& scratch);

/// The surfaces of what the camera sees of the objects' boxes.
std::vector<Polygon> visible_sides(const scene::Scene& scene, const Hexahedron& view);

/// The least and the greatest distance along the view at which the camera sees an object's box;
/// its own near and far where it sees none.
struct DepthRange {
  double near, far;
};
DepthRange depth_present(const scene::Scene& scene, const scene::Camera& camera, double aspect);

}  // namespace shadowlab::shadow
