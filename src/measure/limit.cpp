#include "measure/limit.h"

#include <cmath>
#include <optional>

#include "measure/places.h"

namespace shadowlab::measure {

bool grazed(const truth::Surface& surface, glm::dvec4 light) {
  const glm::dvec3 toward = glm::dvec3(light) - surface.point * light.w;
  return !(std::abs(glm::dot(surface.normal, glm::normalize(toward))) >= 1e-6);
}

Limits::Limits(const scene::Scene& scene, const truth::Tracer& tracer, const recipe::Limit& limit,
               int rows)
    : scene_(std::make_unique<LitScene>(scene, tracer, limit, rows)) {}

Limits::~Limits() = default;

bool Limits::allow(const truth::Surface& surface, bool lit) const {
  return some_place_is(*scene_, surface, lit);
}

bool Limits::allow_a_caster(const truth::Surface& surface) const {
  return is_as_near_as_a_caster(*scene_, surface);
}

std::size_t beyond_limit(const scene::Scene& scene, const truth::Tracer& tracer,
                         const recipe::Limit& limit, const image::FloatImage& drawn,
                         const image::FloatImage& truth, const image::FloatImage& edges,
                         const truth::SurfaceImage& surfaces) {
  std::optional<Limits> limits;  // they cost more than to look whether anything is wrong
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    const float value = drawn.values[i];
    if (edges.values[i] > 0 || std::abs(value - truth.values[i]) <= 0.5f) continue;
    if (!limits) limits.emplace(scene, tracer, limit, drawn.height);
    beyond += !limits->allow(surfaces.surfaces[i], value > 0.5f);
  }
  return beyond;
}

}  // namespace shadowlab::measure
