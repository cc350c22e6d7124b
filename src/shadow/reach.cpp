#include "shadow/reach.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow {
namespace {

// A box that its model leaves thinner than this between two faces, in lengths of the edge across
// them, is none to compute with.
constexpr double flat = 1e-3;

Crate axis_aligned(const scene::Bounds& bounds, const glm::dmat4& model, double room) {
  scene::Bounds box;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) ? bounds.high.x : bounds.low.x,
                            (i & 2) ? bounds.high.y : bounds.low.y,
                            (i & 4) ? bounds.high.z : bounds.low.z);
    const glm::dvec3 world(model * glm::dvec4(corner, 1));
    box.low = glm::min(box.low, world);
    box.high = glm::max(box.high, world);
  }
  const glm::dvec3 half = (box.high - box.low) * 0.5 + room;
  return {box.center(), {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}}};
}

// Where of the crate it is deepest behind the plane, and farthest before it.
glm::dvec2 span_of(const Crate& crate, const glm::dvec4& plane) {
  const glm::dvec3 normal(plane);
  const double middle = glm::dot(normal, crate.center) + plane.w;
  double around = 0;
  for (const glm::dvec3& half : crate.half) around += std::abs(glm::dot(normal, half));
  return {middle - around, middle + around};
}

}  // namespace

Crate crate_around(const scene::Bounds& bounds, const glm::dmat4& model, double room) {
  const glm::dvec3 half = (bounds.high - bounds.low) * 0.5;
  Crate crate{glm::dvec3(model * glm::dvec4(bounds.center(), 1)), {}};
  std::array<glm::dvec3, 3> along;
  for (glm::length_t k = 0; k < 3; ++k) {
    const glm::dvec3 axis(model[k]);
    const double length = glm::length(axis);
    if (!(length > 0)) return axis_aligned(bounds, model, room);
    along[static_cast<std::size_t>(k)] = axis / length;
    crate.half[static_cast<std::size_t>(k)] = axis * half[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 normal = glm::cross(along[(k + 1) % 3], along[(k + 2) % 3]);
    const double across = std::abs(glm::dot(normal, along[k]));
    if (!(across > flat)) return axis_aligned(bounds, model, room);
    // The face moves by `room` along its unit normal.
    crate.half[k] += along[k] * (room * glm::length(normal) / across);
  }
  return crate;
}

Hexahedron hexahedron(const Crate& crate) {
  Hexahedron shape;
  for (std::size_t i = 0; i < 8; ++i) shape.corners[i] = crate.corner(i);
  for (std::size_t k = 0; k < 3; ++k) {
    glm::dvec3 normal =
        glm::normalize(glm::cross(crate.half[(k + 1) % 3], crate.half[(k + 2) % 3]));
    if (glm::dot(normal, crate.half[k]) < 0) normal = -normal;
    const double level = glm::dot(normal, crate.center), half = glm::dot(normal, crate.half[k]);
    shape.planes[2 * k] = glm::dvec4(normal, half - level);
    shape.planes[2 * k + 1] = glm::dvec4(-normal, half + level);
  }
  return shape;
}

ShadowReach::ShadowReach(const Crate& crate, glm::dvec4 light) {
  std::array<glm::dvec3, 8> corners, away;  // where from each corner the shadow goes on
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = crate.corner(i);
    const glm::dvec3 direction =
        light.w > 0 ? corners[i] - glm::dvec3(light) / light.w : -glm::dvec3(light);
    const double length = glm::length(direction);
    if (!(length > 0)) return;  // a corner at the light: everything
    away[i] = direction / length;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 normal = glm::cross(crate.half[(k + 1) % 3], crate.half[(k + 2) % 3]);
    propose(normal, corners, away);
    propose(-normal, corners, away);
    // A light at infinity has one direction for the four edges along this axis.
    const std::size_t edges = light.w > 0 ? 8 : 1;
    for (std::size_t i = 0; i < edges; ++i) {
      if (i >> k & 1) continue;
      const glm::dvec3 side = glm::cross(crate.half[k], away[i]);
      propose(side, corners, away);
      propose(-side, corners, away);
    }
  }
}

// Keeps the half-space behind a plane with this outward normal, moved out until it holds all
// corners, if no direction of the shadow leaves it.
void ShadowReach::propose(glm::dvec3 normal, std::span<const glm::dvec3, 8> corners,
                          std::span<const glm::dvec3, 8> away) {
  const double length = glm::length(normal);
  if (!(length > 0)) return;
  normal /= length;
  // The plane through an edge and the light holds the edge's own directions up to rounding.
  constexpr double rounding = 1e-12;
  double level = -1e300;
  for (std::size_t i = 0; i < 8; ++i) {
    if (glm::dot(normal, away[i]) > rounding) return;
    level = std::max(level, glm::dot(normal, corners[i]));
  }
  planes_[count_++] = glm::dvec4(-normal, level);
}

bool ShadowReach::parts_from(const Crate& crate) const {
  return std::ranges::any_of(planes(),
                             [&](const glm::dvec4& plane) { return span_of(crate, plane).y < 0; });
}

bool ShadowReach::holds(const Crate& crate) const {
  return std::ranges::all_of(planes(),
                             [&](const glm::dvec4& plane) { return span_of(crate, plane).x >= 0; });
}

}  // namespace shadowlab::shadow
