// The cone from a light around what it may shine on.
#pragma once

#include <span>

#include <glm/glm.hpp>

namespace shadowlab::shadow {

struct Cone {
  glm::dvec3 axis{0, -1, 0};  ///< unit
  double half_angle = 0;      ///< radians, in [0, π]
};

/// A cone with its apex at `eye` around all `points`, nearly the narrowest: its half-angle is that
/// of the farthest point from the axis, exactly, and the axis within 2 degrees of the best where
/// the narrowest cone is under 90 degrees (Bădoiu and Clarkson's core-set iteration for the
/// smallest ball around the directions, 2003). Points at the eye make it a half-angle of π; no
/// points, 0.
Cone enclosing_cone(glm::dvec3 eye, std::span<const glm::dvec3> points);

/// Between two unit vectors, radians; exact for small ones too.
double angle(glm::dvec3 a, glm::dvec3 b);

}  // namespace shadowlab::shadow
