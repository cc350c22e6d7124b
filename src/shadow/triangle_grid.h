// A light's map that keeps in each cell not a depth but the triangles which can shadow its points.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {

/// All of a scene's triangles, numbered object by object, and by cell those of casters that can
/// shadow a point of it.
///
/// A double is two floats here, its first 24 bits and the next: what a texture can hold. They tell
/// a place from another by 2^-48 of its distance from `origin`.
struct TriangleGrid {
  /// Of a triangle: own plane and three edges' (TriangleShadow) by their first bits; the same by
  /// their next; its corners a, b, c, each by its first and its next bits (w = 0); two of zeros,
  /// for a shader to count in powers of two.
  static constexpr std::size_t texels = 16;

  glm::dvec3 origin{0};  ///< planes and corners are relative to it, world axes
  std::vector<glm::vec4> triangles;
  /// For cell (x, y), at y * cells + x: where its numbers begin in `list`, and how many there are.
  std::vector<glm::uvec2> ranges;
  std::vector<std::uint32_t> list;
  std::size_t longest = 0;  ///< the numbers of one cell
};

/// For a map of `cells` × `cells` over the window of a LightView's matrices. In a cell that a
/// triangle covers whole, what lies behind that is not listed: it shadows nothing which the
/// covering one does not.
///
/// `light` in world space, w = 0 or w > 0; errors as normalized_light. Throws InputError unless
/// cells is from 1 to 4096.
TriangleGrid triangle_grid(const scene::Scene& scene, glm::dvec4 light, const glm::dmat4& view,
                           const glm::dmat4& projection, int cells);

}  // namespace shadowlab::shadow
