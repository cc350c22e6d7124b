// The edges of a scene's casters, where shadows begin and end.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::measure {

/// From a to b, world space.
struct Edge {
  glm::dvec3 a, b;
  /// How many sides of shadow volumes start at it, at most: one between two triangles that run
  /// along it in opposite ways, where both are on one side of the plane through it and the light,
  /// and none where they are not; else one for each triangle.
  std::size_t sides = 1;
};

/// Each edge of each caster once.
std::vector<Edge> caster_edges(const scene::Scene& scene, glm::dvec4 light);

/// The nearest points of two edges, as parameters of each, 0 at a and 1 at b. Source: C. Ericson,
/// Real-Time Collision Detection, 2005, 5.1.9.
glm::dvec2 nearest(const Edge& p, const Edge& q);

}  // namespace shadowlab::measure
