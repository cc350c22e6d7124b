// Counting without GL: how often a closed surface with vertices at infinity goes round a point, and
// how many triangles are between a point and the light.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "scene/adjacency.h"
#include "scene/exact_sign.h"

namespace shadowlab::shadow {

/// det(a, b, c, d), and the sum of its products' sizes.
template <class Real>
struct Determinant {
  Real value = 0, magnitude = 0;

  Determinant(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d) {
    // The minor of rows a, b in columns i, j times that of rows c, d in columns k, l.
    const auto add = [&](int i, int j, int k, int l) {
      const Real p = Real(a[i]) * b[j], q = Real(a[j]) * b[i];
      const Real r = Real(c[k]) * d[l], s = Real(c[l]) * d[k];
      value += (p - q) * (r - s);
      magnitude += (std::abs(p) + std::abs(q)) * (std::abs(r) + std::abs(s));
    };
    add(0, 1, 2, 3);
    add(0, 2, 3, 1);
    add(0, 3, 1, 2);
    add(1, 2, 0, 3);
    add(1, 3, 2, 0);
    add(2, 3, 0, 1);
  }
};

/// The sign of det(a, b, c, d), or 0 where rounding could have made it: a dozen roundings.
inline int orientation(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                       const glm::dvec4& d) {
  const Determinant<double> quick(a, b, c, d);
  if (std::abs(quick.value) > 0x1p-48 * quick.magnitude) return quick.value > 0 ? 1 : -1;
  const Determinant<long double> slow(a, b, c, d);
  if (std::abs(slow.value) > 0x1p-59L * slow.magnitude) return slow.value > 0 ? 1 : -1;
  return 0;
}

/// How the way from p to q crosses (a, b, c): +1 out of its front, -1 into it, 0 not; nothing where
/// that is too close to tell.
inline std::optional<int> crossing(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                                   const glm::dvec4& p, const glm::dvec4& q) {
  const int at_p = orientation(a, b, c, p), at_q = orientation(a, b, c, q);
  if (at_p == at_q && at_p != 0) return 0;
  const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c),
            ca = orientation(p, q, c, a);
  if (std::max({ab, bc, ca}) > 0 && std::min({ab, bc, ca}) < 0) return 0;
  if (ab == 0 || bc == 0 || ca == 0 || at_p == 0 || at_q == 0) return std::nullopt;
  // det(a, b, c, x) with last column w is negative on the side that sees a, b, c counter-clockwise.
  return at_q < 0 ? 1 : -1;
}

/// How much more often the surface holds p than q.
inline std::optional<int> winding(std::span<const glm::dvec4> positions,
                                  std::span<const std::uint32_t> indices, glm::dvec4 p,
                                  glm::dvec4 q) {
  int sum = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto crossed =
        crossing(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]], p, q);
    if (!crossed) return std::nullopt;
    sum += *crossed;
  }
  return sum;
}

/// How many triangles the segment from p to the light crosses; those whose plane holds the light
/// are seen edge on and cover nothing.
inline std::optional<int> blockers(const scene::Adjacency& mesh, glm::dvec4 p, glm::dvec4 light) {
  int sum = 0;
  for (const scene::Triangle& triangle : mesh.triangles) {
    const glm::vec3 a = mesh.positions[triangle[0]], b = mesh.positions[triangle[1]],
                    c = mesh.positions[triangle[2]];
    if (scene::plane_side(a, b, c, light) == 0) continue;
    const auto crossed = crossing({a, 1}, {b, 1}, {c, 1}, p, light);
    if (!crossed) return std::nullopt;
    sum += std::abs(*crossed);
  }
  return sum;
}

}  // namespace shadowlab::shadow
