// How often a caster can shadow one point: what an 8-bit stencil has room for.
#pragma once

#include <cstddef>

#include "scene/adjacency.h"

namespace shadowlab::shadow {

/// An upper bound for the number of times that a volume of the mesh holds one point, for any light:
/// one for each convex closed component, for any other at most all of its triangles (half of them
/// where it is closed: at least every second crossing leaves it).
std::size_t layers(const scene::Adjacency& adjacency);

}  // namespace shadowlab::shadow
