// A polygon cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace shadowlab::scene {

using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Whether all corners turn the same way, seen along the polygon's normal; straight ones do too.
bool is_convex(std::span<const glm::dvec3> corners);

/// corners.size() − 2 triangles, named by corner, turning as the polygon does. Takes ≥ 3 corners,
/// in order, of a simple polygon that is flat or nearly so; of others it makes triangles all the
/// same. A convex one is a fan; else ears are cut off, in cubic time at worst. Source: G. Meisters,
/// Polygons have ears, 1975.
std::vector<PolygonTriangle> triangulate(std::span<const glm::dvec3> corners);

}  // namespace shadowlab::scene
