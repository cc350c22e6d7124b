// The lecture's loop, kept plain: for each face, for each of its edges, a quad.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "scene/adjacency.h"
#include "shadow/volume.h"

namespace shadowlab::shadow {

/// The lecture's three stages, for a closed mesh with outward faces:
/// all: a quad on every edge of every face. Wrong: the faces turned away count -1 and cancel the
/// lit ones, so the shadow is pierced by cones of light. lit: on every edge of each lit face.
/// Counts are right, but each inner edge has two coincident quads that must cancel, which costs
/// fill and leaves holes where a counter saturates or rounding parts them. silhouette: on a lit
/// face's edge where the face across is not lit. Right.
enum class Edges { all, lit, silhouette };

/// Sides only, as in the lecture; `next` as `scene::next` gives it, -1 counts as not lit.
VolumeMesh volume_lecture(const scene::Adjacency& adjacency,
                          std::span<const std::array<std::int32_t, 3>> next, glm::dvec4 light,
                          Edges edges, double distance = infinite);

}  // namespace shadowlab::shadow
