#include "live/truth_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "truth/tracer.h"

namespace shadowlab::live {
namespace {

constexpr int edge_lattice =
    2;  // points a pixel and axis: coarser than a check's, four times faster

std::uint8_t grey(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

image::FloatImage red_of(const image::Image& picture) {
  image::FloatImage red{picture.width, picture.height, {}};
  red.values.resize(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < red.values.size(); ++i)
    red.values[i] = static_cast<float>(picture.rgba[4 * i]) / 255.0f;
  return red;
}

// The light as the recipe's own words describe it: soft ones have a parameter radius.
scene::Light light_of(const recipe::Recipe& recipe, bool soft) {
  scene::Light light;
  light.position = recipe.light();
  for (const auto& [name, parameter] : recipe.parameters()) {
    if (soft && name == "radius" && parameter.value.size() == 1) {
      light.shape = scene::Light::Shape::sphere;
      light.radius = parameter.value[0];
    }
  }
  return light;
}

struct Question {
  scene::Scene scene;
  scene::Light light;
  bool soft, on_receivers;
  image::FloatImage technique;
};

image::Image picture_of_error(const Question& question, const image::FloatImage& truth,
                              const image::FloatImage& edges) {
  image::Image picture(truth.width, truth.height);
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    const float error = std::abs(question.technique.values[i] - truth.values[i]);
    const auto dim = static_cast<std::uint8_t>(grey(truth.values[i]) / 4);
    std::array<std::uint8_t, 4> color{dim, dim, dim, 255};
    if (question.soft) {
      color[0] = std::max(dim, grey(4 * error));  // a quarter of a step is all red
    } else if (error > 0.5f) {
      color = edges.values[i] != 0 ? std::array<std::uint8_t, 4>{255, 210, 0, 255}
                                   : std::array<std::uint8_t, 4>{255, 40, 30, 255};
    }
    std::ranges::copy(color, picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return picture;
}

}  // namespace

const char* name_of(TruthMode mode) {
  switch (mode) {
    case TruthMode::slider:
      return "truth under a slider";
    case TruthMode::beside:
      return "truth beside";
    case TruthMode::error:
      return "error against the truth";
    default:
      return "no truth";
  }
}

void TruthView::forget() {
  if (result_.valid()) result_.wait();
  result_ = {};
  shows_ = false;
  sentence_.clear();
}

void TruthView::begin(const std::filesystem::path& file, const recipe::Options& options,
                      const recipe::Recipe& running, double time) {
  if (result_.valid()) return;
  const std::string& words = running.description().truth;
  if (words.empty() || !running.scene()) {
    shows_ = false;
    sentence_ = "this recipe is not held against a truth";
    return;
  }
  try {
    recipe::Options twin = options;
    twin.shading = recipe::Options::Shading::visibility;
    twin.time_passes = false;
    twin.print = {};
    twin.on_file = {};
    recipe::Recipe recipe(graphics_, file, twin);
    for (const auto& [name, parameter] : running.parameters())
      recipe.set(name, lua::text_of(parameter));
    recipe.set_camera(running.scene()->camera);
    for (const auto& object : running.scene()->objects) recipe.set_model(object.name, object.model);
    recipe.draw(time);
    const bool soft = words.starts_with("soft");
    Question question{*running.scene(), light_of(running, soft), soft,
                      words.ends_with("on receivers"), red_of(graphics_.frame.read_color())};
    sentence_ = "the truth is being traced …";
    result_ = std::async(std::launch::async, [question = std::move(question)]() mutable {
      const truth::Tracer tracer(question.scene);
      const scene::Camera& camera = question.scene.camera;
      const int width = question.technique.width, height = question.technique.height;
      const auto truth = tracer.visibility(camera, question.light, width, height);
      auto edges = question.technique;
      std::ranges::fill(edges.values, 1.0f);  // all of a penumbra is an edge
      if (!question.soft)
        edges = tracer.edge_mask(camera, question.light, width, height, edge_lattice);
      const auto surfaces = tracer.surfaces(camera, width, height);
      for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
        const truth::Surface& surface = surfaces.surfaces[i];
        const bool claimed = surface.hit() && !(question.on_receivers &&
                                                question.scene.objects[surface.object].casts());
        if (!claimed) question.technique.values[i] = truth.values[i];
      }
      image::Image shown(width, height);
      for (std::size_t i = 0; i < truth.values.size(); ++i)
        std::fill_n(shown.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                    grey(truth.values[i]));
      return Pictures{std::move(shown), picture_of_error(question, truth, edges),
                      truth::compare(question.technique, truth, edges)};
    });
  } catch (const std::exception& problem) {
    shows_ = false;
    sentence_ = problem.what();
  }
}

bool TruthView::poll() {
  using namespace std::chrono_literals;
  if (!result_.valid() || result_.wait_for(0s) != std::future_status::ready) return false;
  try {
    const Pictures pictures = result_.get();
    truth_.upload(pictures.truth);
    error_.upload(pictures.error);
    numbers_ = pictures.numbers;
    sentence_ = fmt::format("{} of {} pixels wrong, {} beyond an edge, RMSE {:.4f}", numbers_.wrong,
                            numbers_.pixels, numbers_.wrong_beyond_edge, numbers_.rmse);
    shows_ = true;
  } catch (const std::exception& problem) {
    shows_ = false;
    sentence_ = problem.what();
  }
  return true;
}

}  // namespace shadowlab::live
