// Closed components that no ray leaves twice.
#pragma once

#include "shadow/volume.h"

namespace shadowlab::shadow {

/// Whether triangles of a closed component lie on the surface of their hull, once: exact, but also
/// false where the component is too large to compare each with each (7,000 triangles).
bool is_convex(const FacingPlanes& faces, TriangleRange closed);

}  // namespace shadowlab::shadow
