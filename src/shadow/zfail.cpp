#include "shadow/zfail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "shadow/facing.h"

namespace shadowlab::shadow {
namespace {

/// The pyramid from the near rectangle to the light; for a direction, a prism without an end.
struct Pyramid {
  std::array<glm::dvec3, 4> base;
  glm::dvec3 toward{0};  // from any corner toward the light, where that is a direction
  glm::dvec3 apex{0};    // the light, where it is a point
  bool pointed = false;

  glm::dvec3 side(std::size_t corner) const { return pointed ? apex - base[corner] : toward; }
};

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

/// The directions that part two convex bodies, one of them bounded, if any does: face normals of
/// either and products of their edges.
// Of the box 3 and of the pyramid 1 + 4 normals, of 3 and 2 + 4 edges the products.
constexpr std::size_t direction_count = 3 + 5 + 3 * 6;

std::array<glm::dvec3, direction_count> parting_directions(const Pyramid& pyramid) {
  const glm::dvec3 right = pyramid.base[1] - pyramid.base[0];
  const glm::dvec3 up = pyramid.base[3] - pyramid.base[0];
  std::array<glm::dvec3, direction_count> directions{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, glm::cross(right, up)}};
  std::size_t count = 4;
  std::array<glm::dvec3, 6> edges{right, up};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 side = pyramid.side(i);
    directions[count++] = glm::cross(i % 2 == 0 ? right : up, side);
    edges[2 + i] = side;
  }
  for (const glm::dvec3& edge : edges) {
    directions[count++] = {0, -edge.z, edge.y};
    directions[count++] = {edge.z, 0, -edge.x};
    directions[count++] = {-edge.y, edge.x, 0};
  }
  return directions;
}

// How far they are apart along `direction`, in its lengths; nothing where it does not part them.
std::optional<double> gap_along(const Pyramid& pyramid, const scene::Bounds& box,
                                glm::dvec3 direction) {
  Interval a, b;
  double magnitude = 0;
  const auto along = [&](glm::dvec3 p) {
    magnitude = std::max(magnitude, glm::dot(glm::abs(direction), glm::abs(p)));
    return glm::dot(direction, p);
  };
  for (const glm::dvec3& corner : pyramid.base) a.add(along(corner));
  if (pyramid.pointed) {
    a.add(along(pyramid.apex));
  } else {
    // A product of the rounded edge `toward` may miss being across it by its roundings.
    const double slope = glm::dot(direction, pyramid.toward);
    const double level = 1e-12 * glm::dot(glm::abs(direction), glm::abs(pyramid.toward));
    if (slope > level) a.high = std::numeric_limits<double>::infinity();
    if (slope < -level) a.low = -std::numeric_limits<double>::infinity();
  }
  for (int corner = 0; corner < 8; ++corner) {
    b.add(along({(corner & 1) != 0 ? box.high.x : box.low.x,
                 (corner & 2) != 0 ? box.high.y : box.low.y,
                 (corner & 4) != 0 ? box.high.z : box.low.z}));
  }
  const double gap = std::max(b.low - a.high, a.low - b.high);
  // A double's rounding, with room; a zero direction parts nothing.
  if (gap > 1e-12 * magnitude) return gap;
  return {};
}

}  // namespace

std::array<glm::dvec3, 4> near_rectangle(const scene::Camera& camera, double aspect) {
  const glm::dmat4 world = glm::inverse(camera.view());
  const double h = camera.near * std::tan(glm::radians(camera.fovy) / 2), w = h * aspect;
  const auto corner = [&](double x, double y) {
    return glm::dvec3(world * glm::dvec4(x, y, -camera.near, 1));
  };
  return {corner(-w, -h), corner(w, -h), corner(w, h), corner(-w, h)};
}

std::optional<Parting> apart_from_near_pyramid(const scene::Camera& camera, double aspect,
                                               glm::dvec4 light, const scene::Bounds& bounds,
                                               const glm::dmat4& model) {
  if (bounds.empty()) return Parting{{0, 1, 0}, std::numeric_limits<double>::infinity()};
  // In model space the box stays a box; being apart does not depend on the space.
  const glm::dvec4 local_light = light_in_model_space(model, light);
  const glm::dmat4 to_model = glm::inverse(model);
  Pyramid pyramid;
  glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  const auto corners = near_rectangle(camera, aspect);
  for (std::size_t i = 0; i < 4; ++i) {
    pyramid.base[i] = glm::dvec3(to_model * glm::dvec4(corners[i], 1));
    farthest = glm::max(farthest, glm::abs(pyramid.base[i]));
  }
  if (local_light.w != 0) {
    pyramid.apex = glm::dvec3(local_light) / local_light.w;
    pyramid.pointed = true;
  } else {
    pyramid.toward = glm::normalize(glm::dvec3(local_light));
  }
  const glm::dvec3 margin(1e-6 * std::max({farthest.x, farthest.y, farthest.z}));
  const scene::Bounds box{bounds.low - margin, bounds.high + margin};
  for (const glm::dvec3& direction : parting_directions(pyramid)) {
    if (const auto gap = gap_along(pyramid, box, direction)) {
      // A plane's normal goes to world space by the inverse transpose.
      const glm::dvec3 normal = glm::transpose(glm::dmat3(to_model)) * direction;
      return Parting{glm::normalize(normal), *gap / glm::length(normal)};
    }
  }
  return {};
}

}  // namespace shadowlab::shadow
