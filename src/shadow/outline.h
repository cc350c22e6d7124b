// A caster's shadow on a plane without its triangles: its silhouette, flattened and filled by
// winding.
//
// Let C be the chain of triangles that count for the light L (volume.h) and F any triangles between
// vertices of C's boundary, with that boundary. C - F is a closed surface in the caster's convex
// hull; what the segment from p to L crosses of it, with sign, is W(p) - W(L), W being its winding
// number, and both are zero outside of the hull. So for p and L outside of it F is crossed
// exactly as often as C: its projection from L onto a plane winds round each point of the
// plane as often as the shadow volume holds it. In the stencil, faces turned one way count up and
// those turned the other way down; what is not zero is in shadow. A few hundred edges stand for
// thousands of triangles. For an open or non-manifold caster the edges have their signed
// multiplicity, as in its volume.
//
// Where L is inside the caster's box (in the hole of a torus), W(L) may be another number; but it
// is one for all points of the plane, and known from how often any one ray from L crosses C and F.
// So F is flattened all the same, and that is added to its count.
//
// Where the plane cuts the caster's box, the counted triangles themselves are flattened: right
// everywhere.
#pragma once

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace shadowlab::shadow {

/// What of a caster is flattened onto a receiver.
enum class Filling {
  none,     ///< nothing: its shadow cannot meet the receiver
  outline,  ///< triangles over its silhouette
  around,   ///< the same of a light in its box: what they count less is found too
  faces,    ///< the triangles that count
};

/// A mesh where its model matrix puts it.
struct Placed {
  scene::Bounds bounds;  ///< model space
  glm::dmat4 model{1};
};

/// `light` in world space, w = 0 or w > 0; `plane`, world space, is the receiver's. `none` is
/// certain, from boxes alone; a light in the plane throws nothing onto it. Throws InputError as
/// `planar` for numbers that are not finite, and where the caster's model matrix is singular.
Filling filling(const Placed& caster, glm::dvec4 light, glm::dvec4 plane, const Placed& receiver);

}  // namespace shadowlab::shadow
