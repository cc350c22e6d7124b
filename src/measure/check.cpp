#include "measure/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "measure/claim.h"
#include "measure/limit.h"
#include "measure/random.h"
#include "truth/tracer.h"

namespace shadowlab::measure {
namespace {

scene::Bounds bounds_of(const scene::Scene& scene, bool casters_alone) {
  scene::Bounds bounds;
  for (const auto& object : scene.objects) {
    if (!casters_alone || object.casts())
      bounds = merge(bounds, scene::bounds(*object.mesh, object.model));
  }
  return bounds;
}

// What is compared in one view, ready for truth::compare: where nothing is claimed both agree.
struct Pictures {
  image::FloatImage technique, truth, edges;
  std::size_t compared = 0;
  std::size_t beyond_limit = 0;
};

class Comparer {
 public:
  Comparer(gl::Graphics& graphics, const std::filesystem::path& file, const CheckOptions& options)
      : graphics_(graphics), options_(options), recipe_(graphics, file, recipe_options(options)) {
    for (const auto& [name, value] : options.settings) recipe_.set(name, value);
    if (!recipe_.scene()) throw InputError(file.string() + " has no scene to compare");
    own_light_ = recipe_.light();
    scene_ = *recipe_.scene();
    tracer_.emplace(scene_);
    claim_ = claim_of(recipe_, file);
  }

  const recipe::Recipe& recipe() const { return recipe_; }

  /// Nothing where the technique does not claim to hold.
  std::optional<Pictures> compare(int index) {
    const View view = view_of(scene_, own_light_, options_.seed, index, options_.nearest);
    recipe_.set_camera(view.camera);
    recipe_.set_light(view.light);
    if (!recipe_.holds()) return {};
    recipe_.draw();
    const int width = graphics_.width(), height = graphics_.height();
    scene::Light light;
    light.position = view.light;
    Pictures pictures{visibility_of(graphics_.frame.read_color()), {}, {}, 0, 0};
    if (claim_.radius) {
      light.shape = scene::Light::Shape::sphere;
      light.radius = *claim_.radius;
      // All of a penumbra is an edge: what tells is the RMSE.
      pictures.edges = pictures.technique;
      std::ranges::fill(pictures.edges.values, 1.0f);
    } else {
      pictures.edges = tracer_->edge_mask(view.camera, light, width, height, options_.per_pixel);
    }
    pictures.truth = tracer_->visibility(view.camera, light, width, height);
    const auto surfaces = tracer_->surfaces(view.camera, width, height);
    for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
      if (claim_.covers(scene_, surfaces.surfaces[i])) {
        ++pictures.compared;
      } else {
        pictures.technique.values[i] = pictures.truth.values[i];
      }
    }
    pictures.beyond_limit = beyond_limit(view, pictures, surfaces);
    return pictures;
  }

 private:
  static recipe::Options recipe_options(const CheckOptions& options) {
    recipe::Options recipe_options;
    recipe_options.scene = options.scene;
    recipe_options.shading = recipe::Options::Shading::visibility;
    return recipe_options;
  }

  // The pixels that are wrong beyond an edge, and beyond what the recipe says of itself.
  std::size_t beyond_limit(const View& view, const Pictures& pictures,
                           const truth::SurfaceImage& surfaces) {
    scene::Scene seen = scene_;
    seen.camera = view.camera;
    seen.lights.assign(1, {.position = view.light});
    return measure::beyond_limit(seen, *tracer_, recipe_.limit(), pictures.technique,
                                 pictures.truth, pictures.edges, surfaces);
  }

  gl::Graphics& graphics_;
  CheckOptions options_;
  recipe::Recipe recipe_;
  scene::Scene scene_;
  glm::dvec4 own_light_{0};
  Claim claim_;
  std::optional<truth::Tracer> tracer_;
};

}  // namespace

View view_of(const scene::Scene& scene, glm::dvec4 light, std::uint64_t seed, int index,
             double nearest) {
  if (index == 0) return {scene.camera, light};
  Random random(seed * 1'000'003 + static_cast<std::uint64_t>(index));
  const scene::Bounds casters = bounds_of(scene, true), all = bounds_of(scene, false);
  const double radius = std::max(casters.radius(), 1e-3);
  const glm::dvec3 center = casters.center();
  View view;
  view.camera.target = center + random.direction() * (0.5 * radius * random.unit());
  view.camera.eye = center + random.direction() * (radius * random.between(0.1, 3.5));
  view.camera.up = random.direction();
  const glm::dvec3 sight = view.camera.target - view.camera.eye;
  if (glm::length(glm::cross(sight, view.camera.up)) < 1e-3 * glm::length(sight))
    view.camera.up = {sight.y, sight.z, sight.x};
  view.camera.fovy = random.between(25, 100);
  view.camera.near = radius * std::pow(10, random.between(std::log10(nearest), -0.5));
  view.camera.far = 4 * (glm::length(view.camera.eye - all.center()) + all.radius());
  const glm::dvec3 toward = random.direction();
  if (random.unit() < 0.25) {
    view.light = glm::dvec4(toward, 0);
  } else {
    view.light = glm::dvec4(center + toward * (radius * random.between(0.3, 4)), 1);
  }
  return view;
}

CheckResult check(gl::Graphics& graphics, const std::filesystem::path& file,
                  const CheckOptions& options) {
  Comparer comparer(graphics, file, options);
  CheckResult result;
  result.recipe = file.stem().string();
  result.scene = comparer.recipe().description().scene;
  double squares = 0;
  for (int index = 0; index < options.views; ++index) {
    const auto pictures = comparer.compare(index);
    if (!pictures) {
      ++result.outside;
      continue;
    }
    const auto row = truth::compare(pictures->technique, pictures->truth, pictures->edges);
    ++result.views;
    result.pixels += pictures->compared;
    result.wrong += row.wrong;
    result.wrong_beyond_edge += row.wrong_beyond_edge;
    result.wrong_beyond_limit += pictures->beyond_limit;
    squares += row.rmse * row.rmse * static_cast<double>(row.pixels);
    if (row.wrong_beyond_edge > 0) result.wrong_views.emplace_back(index, row.wrong_beyond_edge);
  }
  std::ranges::stable_sort(result.wrong_views, std::greater{},
                           &std::pair<int, std::size_t>::second);
  if (result.pixels > 0) result.rmse = std::sqrt(squares / static_cast<double>(result.pixels));
  return result;
}

image::Image picture_of(gl::Graphics& graphics, const std::filesystem::path& file,
                        const CheckOptions& options, int view) {
  Comparer comparer(graphics, file, options);
  const auto pictures = comparer.compare(view);
  const int width = graphics.width(), height = graphics.height();
  image::Image picture(3 * width, height);
  if (!pictures) return picture;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x);
      const auto grey = [](float value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
      };
      const std::uint8_t ours = grey(pictures->technique.values[i]),
                         truth = grey(pictures->truth.values[i]);
      const bool wrong = std::abs(pictures->technique.values[i] - pictures->truth.values[i]) > 0.5f;
      const bool edge = pictures->edges.values[i] != 0;
      picture.set(x, y, {ours, ours, ours, 255});
      picture.set(width + x, y, {truth, truth, truth, 255});
      const auto dim = static_cast<std::uint8_t>(truth / 3 + (edge ? 40 : 0));
      std::array<std::uint8_t, 4> color{dim, dim, dim, 255};
      if (wrong)
        color = edge ? std::array<std::uint8_t, 4>{255, 220, 0, 255}
                     : std::array<std::uint8_t, 4>{255, 0, 0, 255};
      picture.set(2 * width + x, y, color);
    }
  }
  return picture;
}

}  // namespace shadowlab::measure
