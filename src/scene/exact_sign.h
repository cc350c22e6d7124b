// Signs that are never wrong: what is decided about float vertices, decided exactly.
#pragma once

#include <glm/glm.hpp>

namespace shadowlab::scene {

/// The side of the plane of (a, b, c) on which the homogeneous `point` lies: the sign of
/// n·(point.xyz - point.w a) with n = (b-a)×(c-a), so +1 where (a, b, c) is seen counter-clockwise,
/// -1 where clockwise, 0 exactly in the plane or where the triangle has no area. w = 0 is a
/// direction to infinity; a negative w is the same point as its negation only up to sign, so it
/// flips the answer. Exact for every finite input: double arithmetic with a forward error bound,
/// then an exact sum. Source: J. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates, 1997 (the idea of the filter); U. Kulisch's long accumulator (the
/// exact sum).
int plane_side(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::dvec4 point);

/// Whether a, b, c lie on one line (or in one point), exactly.
bool collinear(glm::vec3 a, glm::vec3 b, glm::vec3 c);

}  // namespace shadowlab::scene
