#include "shadow/triangle_shadow.h"

#include <cmath>
#include <utility>

namespace shadowlab::shadow {
namespace {

bool before(glm::dvec3 a, glm::dvec3 b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Through a, b and the light. Computed from the same end whichever triangle asks; and from the
// edge, not as a×b: seen from far away both are nearly the same, and what is left of their product
// is not enough to tell where the plane is.
glm::dvec4 plane_through(glm::dvec3 a, glm::dvec3 b, glm::dvec4 light) {
  const bool turned = before(b, a);
  if (turned) std::swap(a, b);
  const glm::dvec3 n = glm::cross(light.w == 0 ? glm::dvec3(light) : a, b - a);
  const double length = glm::length(n);
  if (!(length > 0)) return glm::dvec4(0);
  const glm::dvec3 unit = n / length;
  const glm::dvec4 plane(unit, light.w == 0 ? -glm::dot(unit, a) : 0.0);
  return turned ? -plane : plane;
}

}  // namespace

TriangleShadow triangle_shadow(const std::array<glm::dvec3, 3>& corners, glm::dvec4 light) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double length = glm::length(n);
  if (!(length > 0)) return {};
  const glm::dvec3 unit = n / length;
  const double d = -glm::dot(unit, a);
  const double toward = light.w == 0 ? glm::dot(unit, glm::dvec3(light)) : d;
  // A product of three differences, each rounded: some 16 roundings of 2^-53 of what is summed, and
  // more where a sliver's normal is itself a small difference.
  const double size = light.w == 0 ? glm::length(glm::dvec3(light)) : glm::length(a);
  const double sides = glm::length(b - a) * glm::length(c - a);
  if (std::abs(toward) <= 1e-14 * size * (sides / length)) return {};
  TriangleShadow shadow;
  const double side = toward > 0 ? 1 : -1;
  shadow.own = glm::dvec4(unit, d) * side;
  // Seen from the light, a, b, c turn counter-clockwise where it is on their positive side.
  for (std::size_t i = 0; i < 3; ++i)
    shadow.edges[i] = plane_through(corners[i], corners[(i + 1) % 3], light) * -side;
  if (light.w == 0) {
    for (glm::dvec4& edge : shadow.edges) edge = -edge;
  }
  return shadow;
}

}  // namespace shadowlab::shadow
