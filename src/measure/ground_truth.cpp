#include "measure/ground_truth.h"

#include <algorithm>

#include "core/clock.h"

namespace shadowlab::measure {
namespace {

constexpr int most_samples = 1 << 14;  // of a pixel; a bar of 1/512 asks for some thousand

// Marks the pixels that have one of `marked` within one pixel.
void grow(std::vector<float>& marked, int width, int height) {
  const std::vector<float> before = marked;
  const auto at = [&](int x, int y) {
    return before[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
                      static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float& here = marked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x)];
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) here = std::max(here, at(x + dx, y + dy));
      }
    }
  }
}

}  // namespace

GroundTruth::GroundTruth(gl::Graphics& graphics, std::filesystem::path reference, std::string scene,
                         double bar)
    : graphics_(graphics),
      reference_(std::move(reference)),
      scene_name_(std::move(scene)),
      bar_(bar) {
  recipe::Options options;
  options.scene = scene_name_;
  const recipe::Recipe recipe(graphics_, reference_, std::move(options));
  scene_ = *recipe.scene();
  light_ = recipe.light();
  tracer_.emplace(scene_);
  surfaces_ = tracer_->surfaces(scene_.camera, graphics_.width(), graphics_.height());
}

const TracedTruth& GroundTruth::of(std::optional<double> radius) {
  const double key = radius.value_or(0);
  auto found = truths_.find(key);
  if (found == truths_.end()) found = truths_.emplace(key, trace(key)).first;
  return found->second;
}

std::vector<std::uint8_t> GroundTruth::compared(const Claim& claim) const {
  std::vector<std::uint8_t> pixels(surfaces_.surfaces.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = claim.covers(scene_, surfaces_.surfaces[i]);
  return pixels;
}

TracedTruth GroundTruth::trace(double radius) {
  const int width = graphics_.width(), height = graphics_.height();
  scene::Light light;
  light.position = light_;
  TracedTruth traced;
  traced.edges = tracer_->edge_mask(scene_.camera, light, width, height);
  truth::Sampling sampling;
  if (radius > 0) {
    light.shape = scene::Light::Shape::sphere;
    light.radius = radius;
    sampling.samples = most_samples;
    sampling.error = bar_;
    traced.bar = bar_;
  }
  const double began = now_ms();
  truth::SoftTruth soft = tracer_->soft_visibility(scene_.camera, light, width, height, sampling);
  traced.milliseconds = now_ms() - began;
  traced.visibility = std::move(soft.visibility);
  traced.rays = soft.rays;
  traced.unconverged = soft.unconverged;
  if (radius > 0) {
    std::vector<float> penumbra(traced.visibility.values.size());
    for (std::size_t i = 0; i < penumbra.size(); ++i) {
      const float seen = traced.visibility.values[i];
      penumbra[i] = seen > 0 && seen < 1 ? 1.0f : 0.0f;
    }
    grow(penumbra, width, height);
    for (std::size_t i = 0; i < penumbra.size(); ++i)
      traced.edges.values[i] = std::max(traced.edges.values[i], penumbra[i]);
  }
  traced.picture = draw_reference(radius);
  return traced;
}

image::Image GroundTruth::draw_reference(double radius) {
  recipe::Options options;
  options.scene = scene_name_;
  recipe::Recipe recipe(graphics_, reference_, std::move(options));
  recipe.set("radius", std::to_string(radius));
  recipe.set("samples", "256");  // under a step of 8 bits is enough for a picture
  recipe.draw();
  return graphics_.frame.read_color();
}

}  // namespace shadowlab::measure
