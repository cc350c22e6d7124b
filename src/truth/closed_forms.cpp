#include "truth/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::truth {
namespace {

// h/(H-h): how far a caster's edge moves on the receiver for each unit that the light moves.
double magnification(Heights heights) {
  if (!(heights.caster >= 0 && heights.caster < heights.light && std::isfinite(heights.light))) {
    throw InputError(fmt::format(
        "A closed form needs the caster between the receiver and the light, not at height {} under "
        "a light at {}.",
        heights.caster, heights.light));
  }
  return heights.caster / (heights.light - heights.caster);
}

// The share of the interval center ± half that lies in [low, high]; for half = 0, whether it does.
double covered_share(double center, double half, double low, double high) {
  if (half == 0) return low <= center && center <= high ? 1 : 0;
  const double overlap = std::min(center + half, high) - std::max(center - half, low);
  return std::clamp(overlap / (2 * half), 0.0, 1.0);
}

// The area of a disk of radius `radius` beyond a chord at signed distance `chord` from its centre.
double segment_area(double radius, double chord) {
  const double t = std::clamp(chord / radius, -1.0, 1.0);
  return radius * radius * (std::acos(t) - t * std::sqrt(1 - t * t));
}

}  // namespace

double penumbra_half_width(double light_half_width, Heights heights) {
  return light_half_width * magnification(heights);
}

double projected_edge(double edge, double light, Heights heights) {
  return edge + (edge - light) * magnification(heights);
}

double half_plane_under_rectangle(double distance, double penumbra_half_width) {
  if (penumbra_half_width == 0) return distance == 0 ? 0.5 : (distance > 0 ? 1 : 0);
  return std::clamp(0.5 + distance / (2 * penumbra_half_width), 0.0, 1.0);
}

double half_plane_under_disk(double distance, double penumbra_half_width) {
  if (penumbra_half_width == 0) return half_plane_under_rectangle(distance, 0);
  const double t = std::clamp(distance / penumbra_half_width, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
}

double half_plane_under_sphere(double distance, double penumbra_half_width) {
  return half_plane_under_rectangle(distance, penumbra_half_width);
}

double rectangle_under_rectangle(glm::dvec2 receiver, glm::dvec2 caster_low, glm::dvec2 caster_high,
                                 glm::dvec2 light_center, glm::dvec2 light_half, Heights heights) {
  magnification(heights);  // refuses heights out of order
  double covered = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double x = receiver[axis];
    if (heights.caster == 0) {
      covered *= covered_share(x, 0, caster_low[axis], caster_high[axis]);
      continue;
    }
    // The caster's edges thrown back from the receiver's point onto the light's plane.
    const double back = heights.light / heights.caster;
    covered *= covered_share(light_center[axis], light_half[axis],
                             x + (caster_low[axis] - x) * back, x + (caster_high[axis] - x) * back);
  }
  return 1 - covered;
}

DiskShadow disk_under_disk(double caster_radius, double light_radius, Heights heights) {
  const double k = magnification(heights);
  const double inner = caster_radius + (caster_radius - light_radius) * k;
  return {.umbra = std::max(0.0, inner),
          .antumbra = std::max(0.0, -inner),
          .penumbra = caster_radius + (caster_radius + light_radius) * k};
}

double disk_under_disk(double distance, double caster_radius, double light_radius,
                       Heights heights) {
  const double k = magnification(heights);
  if (k == 0) return half_plane_under_rectangle(distance - caster_radius, 0);
  if (light_radius == 0) {
    return half_plane_under_rectangle(distance - caster_radius * (1 + k), 0);
  }
  const double s = light_radius;
  const double r = caster_radius * heights.light / heights.caster;
  const double apart = std::abs(distance) / k;
  if (apart >= r + s) return 1;
  if (apart <= std::abs(r - s)) return r >= s ? 0 : 1 - (r * r) / (s * s);
  // The common chord, from the light's centre; the lens is a segment of each circle.
  const double chord = (apart * apart + s * s - r * r) / (2 * apart);
  const double lens = segment_area(s, chord) + segment_area(r, apart - chord);
  return 1 - lens / (std::numbers::pi * s * s);
}

}  // namespace shadowlab::truth
