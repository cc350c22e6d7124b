#include "scene/polygon.h"

#include <numeric>

namespace shadowlab::scene {

namespace {

/// Twice the signed area of a triangle, positive when counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along the axis nearest to its normal, counter-clockwise. Dropping a coordinate
/// rounds nothing, so what is straight in space stays straight.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners) {
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const glm::dvec3 size = glm::abs(normal);
  int axis = size.x > size.y ? 0 : 1;
  if (size.z > size[axis]) axis = 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : corners) {
    flat.push_back(normal[axis] >= 0.0 ? glm::dvec2(p[u], p[v]) : glm::dvec2(p[v], p[u]));
  }
  return flat;
}

bool turns_left_everywhere(std::span<const glm::dvec2> flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0.0) return false;
  }
  return true;
}

bool covers(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p) {
  if (p == t[0] || p == t[1] || p == t[2]) return false;
  return turn(t[0], t[1], p) >= 0.0 && turn(t[1], t[2], p) >= 0.0 && turn(t[2], t[0], p) >= 0.0;
}

/// Where the next ear is in `left`, the corners not yet cut off; of a polygon that has none, since
/// it is degenerate or crosses itself, any place will do.
std::size_t ear(std::span<const glm::dvec2> flat, std::span<const std::uint32_t> left) {
  const std::size_t n = left.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<glm::dvec2, 3> corner{flat[left[(i + n - 1) % n]], flat[left[i]],
                                           flat[left[(i + 1) % n]]};
    if (turn(corner[0], corner[1], corner[2]) <= 0.0) continue;
    bool free = true;
    for (std::size_t j = 0; free && j < n; ++j) free = !covers(corner, flat[left[j]]);
    if (free) return i;
  }
  return 0;
}

}  // namespace

bool is_convex(std::span<const glm::dvec3> corners) {
  return turns_left_everywhere(flattened(corners));
}

std::vector<PolygonTriangle> triangulate(std::span<const glm::dvec3> corners) {
  const std::vector<glm::dvec2> flat = flattened(corners);
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  std::vector<PolygonTriangle> triangles;
  if (turns_left_everywhere(flat)) {
    for (std::uint32_t i = 2; i < left.size(); ++i) triangles.push_back({0, i - 1, i});
    return triangles;
  }
  while (left.size() > 3) {
    const std::size_t n = left.size(), i = ear(flat, left);
    triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace shadowlab::scene
