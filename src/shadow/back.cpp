#include "shadow/back.h"

#include <array>
#include <cmath>

namespace shadowlab::shadow {
namespace {

// What GL's floats may move a corner across the near plane by, in its own coordinates.
constexpr double rounding = 1e-5;

}  // namespace

bool fills_its_box(const scene::Mesh& mesh) {
  if (mesh.triangle_count() != 12) return false;
  const scene::Bounds box = scene::bounds(mesh);
  // Of each face, which of its corners its triangles leave out.
  std::array<unsigned, 6> left_out{};
  for (std::size_t t = 0; t < 12; ++t) {
    std::array<unsigned, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 p(mesh.positions[mesh.indices[3 * t + k]]);
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        if (p[axis] == box.high[axis])
          corners[k] |= 1u << axis;
        else if (p[axis] != box.low[axis])
          return false;
      }
    }
    const unsigned same = ~((corners[0] ^ corners[1]) | (corners[0] ^ corners[2])) & 7u;
    if (same != 1 && same != 2 && same != 4) return false;  // across the box, or a line
    // Corners of a face: the sum of all four, by their two bits, is even; so the one left out is
    // the three's.
    const unsigned missing = corners[0] ^ corners[1] ^ corners[2];
    const unsigned face = (same >> 1) * 2 + ((corners[0] & same) ? 1u : 0u);
    left_out[face] |= 1u << missing;
  }
  for (std::size_t face = 0; face < 6; ++face) {
    const unsigned across = 7u & ~(face < 2 ? 1u : face < 4 ? 2u : 4u);
    bool whole = false;
    for (unsigned corner = 0; corner < 8; ++corner)
      whole = whole || (left_out[face] >> corner & left_out[face] >> (corner ^ across) & 1u);
    if (!whole) return false;
  }
  return true;
}

bool is_turned_out(const scene::Mesh& mesh) {
  const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.indices[i]]); };
  glm::dvec3 middle(0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    middle += corner(i) / static_cast<double>(mesh.indices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(i), normal = glm::cross(corner(i + 1) - a, corner(i + 2) - a);
    if (!(glm::dot(normal, a - middle) > 0)) return false;
  }
  return true;
}

bool hides_its_back(const scene::Bounds& bounds, const glm::dmat4& to_clip) {
  // GL's projections look down -z to a near plane at z = -w: they turn space round, and so does all
  // of `to_clip`, unless something in it mirrors.
  if (!(glm::determinant(to_clip) < 0)) return false;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 corner((i & 1) ? bounds.high.x : bounds.low.x,
                            (i & 2) ? bounds.high.y : bounds.low.y,
                            (i & 4) ? bounds.high.z : bounds.low.z, 1);
    const glm::dvec4 p = to_clip * corner;
    if (!(p.z + p.w > rounding * (std::abs(p.z) + std::abs(p.w)))) return false;
  }
  return true;
}

}  // namespace shadowlab::shadow
