#include "measure/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "measure/claim.h"
#include "truth/comparison.h"

namespace shadowlab::measure {
namespace {

// Whether the light is in the plane of what is seen. There lit and dark are a tie, which each
// technique decides as it likes, and Lambert's cosine is 0: nobody sees which.
bool grazed(const truth::Surface& surface, glm::dvec4 light) {
  const glm::dvec3 toward = glm::dvec3(light) - surface.point * light.w;
  return std::abs(glm::dot(surface.normal, glm::normalize(toward))) < 1e-6;
}

// Whether the trial departs, and how.
bool departs(gl::Graphics& graphics, const std::filesystem::path& recipe, const Trial& trial,
             Departure& how) {
  try {
    const auto wrong = wrong_beyond_edge(graphics, recipe, trial);
    how.beyond_edge = wrong.value_or(0);
    how.error.clear();
    return how.beyond_edge > 0;
  } catch (const InputError& problem) {
    how.error = problem.what();
    return true;
  }
}

recipe::Options drawing_visibility() {
  recipe::Options options;
  options.shading = recipe::Options::Shading::visibility;
  return options;
}

}  // namespace

std::optional<std::size_t> wrong_beyond_edge(gl::Graphics& graphics,
                                             const std::filesystem::path& file,
                                             const Trial& trial) {
  recipe::Recipe recipe(graphics, file, drawing_visibility());
  const scene::Scene scene = scene_of(trial);
  recipe.set_light(scene.lights[0].position);
  recipe.set_scene(scene);
  if (!recipe.holds()) return {};
  recipe.draw();
  const int width = graphics.width(), height = graphics.height();
  image::FloatImage drawn = visibility_of(graphics.frame.read_color());
  const truth::Tracer tracer(scene);
  const Claim claim = claim_of(recipe, file);
  const auto truth = tracer.visibility(scene.camera, scene.lights[0], width, height);
  const auto surfaces = tracer.surfaces(scene.camera, width, height);
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    const truth::Surface& surface = surfaces.surfaces[i];
    if (!claim.covers(scene, surface) || grazed(surface, scene.lights[0].position))
      drawn.values[i] = truth.values[i];
  }
  // Edges cost sixteen times the truth, so that they are looked for where something is wrong alone.
  image::FloatImage none = truth;
  std::fill(none.values.begin(), none.values.end(), 0.0f);
  if (truth::compare(drawn, truth, none).wrong == 0) return 0;
  const auto edges = tracer.edge_mask(scene.camera, scene.lights[0], width, height);
  return truth::compare(drawn, truth, edges).wrong_beyond_edge;
}

Trial shrunk(Trial trial, const std::function<bool(const Trial&)>& departs, int most) {
  for (bool simpler_found = true; simpler_found && most > 0;) {
    simpler_found = false;
    for (const Trial& next : simpler(trial)) {
      if (most-- <= 0) break;
      if (!departs(next)) continue;
      trial = next;
      simpler_found = true;
      break;
    }
  }
  return trial;
}

std::vector<Departure> search(gl::Graphics& graphics, const SearchOptions& options,
                              const std::function<void(const Progress&)>& progress,
                              const std::function<void(const Departure&)>& found) {
  std::vector<Departure> all;
  for (std::uint64_t i = 0; i < options.trials; ++i) {
    const std::uint64_t index = options.first + i;
    const Trial trial = trial_of(options.seed, index);
    if (progress) progress({i, options.trials, fmt::format("{} departures", all.size())});
    for (const auto& recipe : options.recipes) {
      Departure departure{recipe.stem().string(), index, trial, 0, ""};
      if (!departs(graphics, recipe, trial, departure)) continue;
      const bool fails = !departure.error.empty();
      departure.trial = shrunk(trial, [&](const Trial& next) {
        Departure how{};
        return departs(graphics, recipe, next, how) && !how.error.empty() == fails;
      });
      departs(graphics, recipe, departure.trial, departure);
      if (found) found(departure);
      all.push_back(std::move(departure));
    }
  }
  return all;
}

}  // namespace shadowlab::measure
