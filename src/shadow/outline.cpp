#include "shadow/outline.h"

#include <algorithm>
#include <cmath>

#include "shadow/facing.h"
#include "shadow/reach.h"

namespace shadowlab::shadow {
namespace {

bool holds(const scene::Bounds& box, glm::dvec4 light) {
  if (light.w == 0) return false;
  for (int i = 0; i < 3; ++i) {
    if (light[i] < light.w * box.low[i] || light[i] > light.w * box.high[i]) return false;
  }
  return true;
}

}  // namespace

Filling filling(const Placed& caster, glm::dvec4 light, glm::dvec4 plane, const Placed& receiver) {
  if (caster.bounds.empty() || receiver.bounds.empty()) return Filling::none;
  light = normalized_light(light);
  const glm::dvec4 in_model = light_in_model_space(caster.model, light);
  plane /= glm::length(glm::dvec3(plane));
  const double height = glm::dot(plane, light);
  if (std::abs(height) < 1e-9 * glm::length(glm::dvec3(light))) return Filling::none;
  if (height < 0) plane = -plane;

  // What may be lost to rounding, of coordinates and of products with them.
  const Crate exact = crate_around(caster.bounds, caster.model, 0);
  double size = std::abs(plane.w), own = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    size = std::max(size, glm::length(exact.corner(i)));
    own = std::max(own, glm::distance(exact.corner(i), glm::dvec3(caster.model[3])));
  }
  const double room = 1e-6 * size;
  double lowest = 1e300, highest = -1e300;
  for (std::size_t i = 0; i < 8; ++i) {
    const double over = glm::dot(plane, glm::dvec4(exact.corner(i), 1));
    lowest = std::min(lowest, over);
    highest = std::max(highest, over);
  }
  if (highest < -room) return Filling::none;
  if (light.w != 0 && lowest > std::abs(height) / light.w + room) return Filling::none;
  if (ShadowReach(crate_around(caster.bounds, caster.model, room), light)
          .parts_from(crate_around(receiver.bounds, receiver.model, room)))
    return Filling::none;
  // A caster that stands on the plane does not cut it: its vertices are floats, placed in double.
  if (lowest < -(0x1p-22 * own + 0x1p-46 * size)) return Filling::faces;
  return holds(caster.bounds, in_model) ? Filling::around : Filling::outline;
}

}  // namespace shadowlab::shadow
