#include "shadow/convex.h"

#include "scene/exact_sign.h"

namespace shadowlab::shadow {
namespace {

// Deciding convexity compares every vertex with every face; larger components count as not convex.
constexpr std::size_t most_comparisons = 50'000'000;

// How many triangles of a component that lies on its hull's surface, turned alike, lie over one
// point, the middle of the first: as many as over any other, since the component has no boundary.
std::size_t sheets(const FacingPlanes& faces, TriangleRange range) {
  const auto corner = [&](std::size_t triangle, std::size_t k) {
    return faces.positions()[faces.triangles()[triangle][k]];
  };
  const glm::dvec3 a(corner(range.first, 0)), b(corner(range.first, 1)), c(corner(range.first, 2));
  const glm::dvec3 middle = (a + b + c) / 3.0, normal = glm::cross(b - a, c - a);
  std::size_t count = 0;
  for (std::size_t t = range.first; t < range.last; ++t) {
    bool over = true;
    for (std::size_t k = 0; k < 3 && over; ++k) {
      const glm::dvec3 p(corner(t, k)), q(corner(t, (k + 1) % 3));
      over = scene::plane_side(corner(range.first, 0), corner(range.first, 1),
                               corner(range.first, 2), glm::dvec4(p, 1)) == 0;
      // One that only touches the point up to rounding may count: it is then not called convex.
      const double size = glm::length(normal) * glm::length(q - p) * glm::length(middle - p);
      over = over && glm::dot(normal, glm::cross(q - p, middle - p)) >= -1e-9 * size;
    }
    if (over) ++count;
  }
  return count;
}

}  // namespace

bool is_convex(const FacingPlanes& faces, TriangleRange range) {
  if (range.count() * range.count() > most_comparisons) return false;
  const auto corner = [&](std::size_t triangle, std::size_t k) {
    return faces.positions()[faces.triangles()[triangle][k]];
  };
  bool above = false, below = false;
  for (std::size_t face = range.first; face < range.last; ++face) {
    for (std::size_t other = range.first; other < range.last; ++other) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int side = scene::plane_side(corner(face, 0), corner(face, 1), corner(face, 2),
                                           glm::dvec4(corner(other, k), 1));
        above = above || side > 0;
        below = below || side < 0;
      }
    }
    if (above && below) return false;
  }
  return sheets(faces, range) == 1;
}

}  // namespace shadowlab::shadow
