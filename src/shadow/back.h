// Whether a body's own front hides its back from the camera, at every pixel.
#pragma once

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace shadowlab::shadow {

/// Whether the mesh is its own box, closed: twelve triangles, two on each face, of its corners.
bool fills_its_box(const scene::Mesh& mesh);

/// Whether of a mesh that does the triangles are counter-clockwise seen from outside.
bool is_turned_out(const scene::Mesh& mesh);
/// Both.
inline bool is_solid_box(const scene::Mesh& mesh) {
  return fills_its_box(mesh) && is_turned_out(mesh);
}

/// Whether, under `to_clip` (model to clip space), no triangle of a solid box with these bounds
/// that is turned from the eye need be drawn: there is no mirror, and the near plane does not cut
/// it. Over each pixel's centre its corners, rounded to GL's grid as they may be, turn as often one
/// way as the other; so where a back triangle is drawn a front one is too. Drawn, the back may win
/// a pixel of the outline, by that rounding.
bool hides_its_back(const scene::Bounds& bounds, const glm::dmat4& to_clip);

}  // namespace shadowlab::shadow
