#include "measure/average.h"

#include <cmath>
#include <deque>
#include <optional>

#include "measure/limit.h"

namespace shadowlab::measure {
namespace {

// The hard shadow of one point, and what of it is asked for only where the average is off.
class HardShadow {
 public:
  HardShadow(const scene::Scene& scene, const truth::Tracer& tracer, const recipe::Limit& limit,
             glm::dvec4 point, int width, int height)
      : scene_(scene), tracer_(tracer), limit_(limit), width_(width), height_(height) {
    scene_.lights.assign(1, {.position = point});
    truth_ = tracer.visibility(scene_.camera, scene_.lights[0], width, height);
  }

  bool lit(std::size_t pixel) const { return truth_.values[pixel] > 0.5f; }

  bool may_be(std::size_t pixel, const truth::Surface& surface, bool lit) {
    if (edges_.values.empty())
      edges_ = tracer_.edge_mask(scene_.camera, scene_.lights[0], width_, height_);
    return edges_.values[pixel] > 0 || grazed(surface, scene_.lights[0].position) ||
           limits().allow(surface, lit);
  }

  const Limits& limits() {
    if (!limits_) limits_.emplace(scene_, tracer_, limit_, height_);
    return *limits_;
  }

 private:
  scene::Scene scene_;
  const truth::Tracer& tracer_;
  recipe::Limit limit_;
  int width_, height_;
  image::FloatImage truth_, edges_;
  std::optional<Limits> limits_;
};

}  // namespace

std::size_t wrong_average(const scene::Scene& scene, const truth::Tracer& tracer,
                          const recipe::Limit& limit, const Claim& claim,
                          std::span<const glm::dvec4> points, const image::FloatImage& drawn) {
  std::deque<HardShadow> shadows;  // none is moved: limits refer to their scene
  for (const glm::dvec4 point : points)
    shadows.emplace_back(scene, tracer, limit, point, drawn.width, drawn.height);
  const auto surfaces = tracer.surfaces(scene.camera, drawn.width, drawn.height);
  const auto all = static_cast<double>(points.size());
  // Half a step of the picture, and for each point half a step of what accumulates in 16 bits.
  const double rounding = 0.5 / 255 + all * 0x1p-16;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    const truth::Surface& surface = surfaces.surfaces[i];
    if (!claim.covers(scene, surface)) continue;
    double lit = 0;
    for (const HardShadow& shadow : shadows) lit += shadow.lit(i) ? 1 : 0;
    double off = std::abs(drawn.values[i] * all - lit) - rounding * all;
    const bool too_light = drawn.values[i] * all > lit;
    for (HardShadow& shadow : shadows) {
      if (off <= 0) break;
      if (shadow.lit(i) != too_light && shadow.may_be(i, surface, too_light)) off -= 1;
    }
    if (off > 0 && claim.on_receivers && shadows[0].limits().allow_a_caster(surface)) continue;
    wrong += off > 0;
  }
  return wrong;
}

}  // namespace shadowlab::measure
