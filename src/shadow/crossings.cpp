#include "shadow/crossings.h"

#include <array>
#include <cmath>

namespace shadowlab::shadow {
namespace {

// A sum of products and the sum of their sizes: its sign, 0 where a dozen roundings could have made
// it.
struct Sum {
  double value = 0, size = 0;
  void add(double p) {
    value += p;
    size += std::abs(p);
  }
  int sign() const { return std::abs(value) <= 0x1p-48 * size ? 0 : value > 0 ? 1 : -1; }
};

// The ray is the axis of the last coordinate, from the origin on.
std::optional<int> crossing(const std::array<glm::dvec3, 3>& at) {
  std::array<Sum, 3> across;  // of the edge that is opposite to each corner
  bool some_left = false, some_right = false, sure = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = at[(i + 1) % 3], &b = at[(i + 2) % 3];
    across[i].add(a.x * b.y);
    across[i].add(-(a.y * b.x));
    const int sign = across[i].sign();
    some_left = some_left || sign > 0;
    some_right = some_right || sign < 0;
    sure = sure && sign != 0;
  }
  if (some_left && some_right) return 0;
  if (!sure) return std::nullopt;
  Sum height;
  for (std::size_t i = 0; i < 3; ++i) height.add(across[i].value * at[i].z);
  const int turned = some_left ? 1 : -1, above = height.sign() * turned;
  if (above == 0) return std::nullopt;
  return above > 0 ? turned : 0;
}

}  // namespace

std::optional<int> crossings(std::span<const glm::vec4> vertices,
                             std::span<const std::uint32_t> triangles, glm::dvec3 from, int axis) {
  const glm::length_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  int count = 0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    std::array<glm::dvec3, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec4& p = vertices[triangles[t + k]];
      at[k] = {double(p[u]) - from[u], double(p[v]) - from[v], double(p[axis]) - from[axis]};
    }
    const auto beside = [&](glm::length_t c) {
      return (at[0][c] > 0 && at[1][c] > 0 && at[2][c] > 0) ||
             (at[0][c] < 0 && at[1][c] < 0 && at[2][c] < 0);
    };
    if (beside(0) || beside(1) || (at[0].z < 0 && at[1].z < 0 && at[2].z < 0)) continue;
    const auto once = crossing(at);
    if (!once) return std::nullopt;
    count += *once;
  }
  return count;
}

}  // namespace shadowlab::shadow
