// The error of light sampling: RMSE of soft_accumulated against rays to all of the light.
//
//   bench_soft [SIZE]
//
// Each pattern with 4, 16, 64 and 256 points over four scenes, each from its own camera, under a
// sphere of a tenth of its distance from the casters. The slope is that of the line through the
// logarithms: -0.5 for independent points. Seeded patterns are averaged over 32 seeds of 4 points
// to 4 of 256: so few leave random's own error uncertain by some per cent. The truth
// takes points of its own at each pixel until its standard error is under 1/500. What is left at
// 256 points is partly the picture's 8 bits (0.0011).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/version.h"
#include "recipe/recipe.h"
#include "shadow/samples.h"
#include "truth/tracer.h"

namespace shadowlab {
namespace {

constexpr std::array scenes{"room", "comb", "tetra", "cornell"};
constexpr std::array counts{4, 16, 64, 256};

double size_of_light(const scene::Scene& scene, glm::dvec3 light) {
  scene::Bounds casters;
  for (const auto& object : scene.objects) {
    if (object.casts()) casters = merge(casters, scene::bounds(*object.mesh, object.model));
  }
  return 0.1 * glm::length(light - casters.center());
}

// One scene's truth, and where it has surfaces.
struct Reference {
  explicit Reference(const scene::Scene& scene, glm::dvec4 light, int size) {
    const truth::Tracer tracer(scene);
    radius = size_of_light(scene, light);
    scene::Light sphere;
    sphere.position = light;
    sphere.shape = scene::Light::Shape::sphere;
    sphere.radius = radius;
    truth::Sampling sampling;
    sampling.samples = 4096;
    sampling.seed = 1234;
    sampling.error = 0.002;
    visibility = tracer.visibility(scene.camera, sphere, size, size, sampling);
    surfaces = tracer.surfaces(scene.camera, size, size);
  }
  double rmse(const image::Image& picture) const {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
      if (!surfaces.surfaces[i].hit()) continue;
      const double off = picture.rgba[4 * i] / 255.0 - static_cast<double>(visibility.values[i]);
      squares += off * off;
      ++count;
    }
    return std::sqrt(squares / count);
  }
  double radius = 0;
  image::FloatImage visibility;
  truth::SurfaceImage surfaces;
};

// Of the least squares line through (log N, log error).
double slope(const std::array<double, counts.size()>& errors) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double u = std::log(counts[i]), v = std::log(errors[i]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void run(int size) {
  gl::Graphics graphics(context::create(), size, size);
  std::array<std::array<std::array<double, counts.size()>, scenes.size()>, 7> errors{};
  const auto patterns = shadow::pattern_names();
  fmt::print("{:10} {:11} {:>8} {:>8} {:>8} {:>8} {:>7}\n", "scene", "pattern", "4", "16", "64",
             "256", "slope");
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    recipe::Options options;
    options.scene = scenes[s];
    options.limits.seconds = 3600;
    options.shading = recipe::Options::Shading::visibility;
    recipe::Recipe recipe(graphics, home() / "scripts" / "soft_accumulated.lua", options);
    const Reference reference(*recipe.scene(), recipe.light(), size);
    recipe.set("radius", fmt::format("{}", reference.radius));
    recipe.set("storage", "float32");
    for (std::size_t p = 0; p < patterns.size(); ++p) {
      auto& row = errors[p][s];
      recipe.set("pattern", std::string(patterns[p]));
      for (std::size_t n = 0; n < counts.size(); ++n) {
        recipe.set("samples", std::to_string(counts[n]));
        const bool seeded = shadow::is_seeded(*shadow::pattern_named(patterns[p]));
        const int seeds = seeded ? std::max(4, 32 >> n) : 1;
        double squares = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
          recipe.set("seed", std::to_string(seed));
          recipe.draw();
          const double rmse = reference.rmse(graphics.frame.read_color());
          squares += rmse * rmse;
        }
        row[n] = std::sqrt(squares / seeds);
      }
      fmt::print("{:10} {:11} {:8.5f} {:8.5f} {:8.5f} {:8.5f} {:7.2f}\n", scenes[s], patterns[p],
                 row[0], row[1], row[2], row[3], slope(row));
    }
  }
  for (std::size_t p = 0; p < patterns.size(); ++p) {
    std::array<double, counts.size()> mean{};
    for (std::size_t n = 0; n < counts.size(); ++n) {
      for (const auto& row : errors[p]) mean[n] += row[n] / static_cast<double>(scenes.size());
    }
    fmt::print("{:10} {:11} {:8.5f} {:8.5f} {:8.5f} {:8.5f} {:7.2f}\n", "mean", patterns[p],
               mean[0], mean[1], mean[2], mean[3], slope(mean));
  }
}

}  // namespace
}  // namespace shadowlab

int main(int count, char** arguments) { shadowlab::run(count > 1 ? std::atoi(arguments[1]) : 128); }
