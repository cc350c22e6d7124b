// The shadow of a caster on a plane, as a 4×4 projection.
//
// With a plane P = (a, b, c, d), P·v = 0 for its points, and a light L = (x, y, z, w), w = 0 being
// the direction toward a light at infinity, the line from L through v meets the plane in
//
//   v' = (P·L) v − (P·v) L,     that is   M = (P·L) I − L Pᵀ     for column vectors.
//
// The shadow is where v lies between plane and light: there w' > 0 if P·L > 0, which the functions
// below see to by choosing the plane's sign; with the other sign GL's clipping removes the shadow
// and keeps the images of what is behind the light. A vertex as high over the plane as the light
// has w' = 0: its shadow is a direction, which GL clips as it should. M does not know what lies
// below the plane: `planar_reach` tells when the plane itself must clip the caster.
//
// M is singular where P·L = 0: a light in the plane throws no shadow on it.
//
// Precision: at a distance r from the origin M has entries of size r², and what a product with it
// loses cannot be won back, in double or any other way. The largest error of a shadow's position in
// eye space, for a scene of 10 units and an oblique plane (planar_test.cpp measures and holds
// them):
//
//   world moved by               0      1e3    1e5    1e6
//   M, everything in float       2e-6   1e-2   2e2    1e4
//   M in double                  6e-15  2e-11  1e-7   1e-5
//   PlanarProjection in double   6e-15  3e-13  2e-11  2e-10
//   the same, then to float      2e-6   2e-6   2e-6   2e-6
//
// Source: J. Blinn, Me and My (Fake) Shadow, IEEE CG&A 8(1), 1988.
#pragma once

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace shadowlab::shadow {

/// World to world: onto `plane` from `light`, scaled by a power of two such that 1 ≤ P·L < 2 (so
/// small whole numbers give exact entries). Throws InputError where a number is not finite, the
/// plane's normal or the light is zero, or the light is in the plane within rounding.
glm::dmat4 planar(glm::dvec4 plane, glm::dvec4 light);

/// The lecture's three forms. The light at the world's origin:
glm::dmat4 planar_from_origin(glm::dvec4 plane);
/// The light at `point`:
glm::dmat4 planar_from_point(glm::dvec4 plane, glm::dvec3 point);
/// Along `direction`, which may be the way the light travels or the way back to it: a line has no
/// sense, and the matrix is the same, bit for bit.
glm::dmat4 planar_along(glm::dvec4 plane, glm::dvec3 direction);

/// The same projection for a world far from its origin: M = T(origin) · local · T(−origin), which
/// is never multiplied out.
struct PlanarProjection {
  glm::dvec3 origin;  ///< a point of the plane, world space
  glm::dmat4 local;   ///< as `planar`, for coordinates relative to `origin`
};

/// `near` is any point near the picture, for example the caster's or the receiver's centre.
PlanarProjection planar_near(glm::dvec4 plane, glm::dvec4 light, glm::dvec3 near);

/// view · T(origin) · local · T(−origin) · model, grouped such that the large numbers cancel first.
/// `model` is affine.
glm::dmat4 model_view(const PlanarProjection& projection, const glm::dmat4& view,
                      const glm::dmat4& model);

/// `plane` with a unit normal and the light on its positive side: what a clip distance takes to
/// keep the part of a caster above the plane. Errors as `planar`.
glm::dvec4 plane_toward(glm::dvec4 plane, glm::dvec4 light);

/// How much of a caster can shadow a plane.
enum class PlanarReach {
  none,   ///< all of it is below the plane or in it, or as high as the light or higher
  part,   ///< clip it by `plane_toward`; above the light GL's clipping of w' < 0 does it
  whole,  ///< all of it is between plane and light, or touches the plane from above
};

/// For everything in `caster`, world space. Within rounding of the plane counts as in it. Errors as
/// `planar`; an empty box reaches nothing.
PlanarReach planar_reach(glm::dvec4 plane, glm::dvec4 light, const scene::Bounds& caster);

/// World space to the unit cube of a receiver, the parallelogram corner + s·ex + t·ey: x and y are
/// the (s, t) of a point's shadow on it, z grows from 0 near the light to 1 on the receiver, and
/// what is behind the receiver is beyond 1. For a point light z = 0 is 1/1024 of the way from light
/// to receiver; for a direction 1024 times the longer side away. Throws InputError where a number
/// is not finite, ex and ey are parallel, or the light is in the receiver's plane within rounding.
/// Source: P. Heckbert, M. Herf, Simulating Soft Shadows with Graphics Hardware, CMU-CS-97-104,
/// 1997; the depth is ours, theirs keeps none.
glm::dmat4 parallelogram(glm::dvec3 corner, glm::dvec3 ex, glm::dvec3 ey, glm::dvec4 light);

}  // namespace shadowlab::shadow
