#include "measure/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/clock.h"
#include "core/error.h"
#include "measure/average.h"
#include "measure/claim.h"
#include "measure/limit.h"
#include "truth/comparison.h"

namespace shadowlab::measure {
namespace {

recipe::Options drawing_visibility() {
  recipe::Options options;
  options.shading = recipe::Options::Shading::visibility;
  return options;
}

void set_up(recipe::Recipe& recipe, const Searched& searched, const Trial& trial,
            const scene::Scene& scene) {
  // A lamp is as large as the world makes it, where no setting says another radius.
  for (const auto& [name, parameter] : recipe.parameters()) {
    if (name == "radius") recipe.set(name, fmt::format("{}", std::min(0.25 * trial.unit, 1.0)));
  }
  for (const auto& [name, value] : searched.settings) recipe.set(name, value);
  // Of soft shadows it is the number of points: that changes nothing but the time.
  const bool sweeps = trial.swept && !claim_of(recipe, searched.file).soft();
  for (const recipe::Swept& swept : recipe.description().sweep) {
    if (!sweeps) break;
    const auto at =
        static_cast<std::size_t>(*trial.swept * static_cast<double>(swept.values.size()));
    recipe.set(swept.name, swept.values[std::min(at, swept.values.size() - 1)]);
  }
  recipe.set_light(scene.lights[0].position);
  recipe.set_scene(scene);
}

// Contexts by picture size: programs are compiled once for all trials of a size.
class Screens {
 public:
  gl::Graphics& of(const Trial& trial) {
    auto& graphics = screens_[{trial.width, trial.height}];
    if (!graphics)
      graphics = std::make_unique<gl::Graphics>(context::create(), trial.width, trial.height);
    graphics->context().make_current();
    return *graphics;
  }

 private:
  std::map<std::pair<int, int>, std::unique_ptr<gl::Graphics>> screens_;
};

enum class Outcome { outside, right, wrong, fails };

Outcome outcome_of(Screens& screens, const Searched& recipe, const Trial& trial, Departure& how) {
  try {
    const auto wrong = wrong_beyond_limit(screens.of(trial), recipe, trial);
    how.beyond_edge = wrong.value_or(0);
    how.error.clear();
    if (!wrong) return Outcome::outside;
    return *wrong > 0 ? Outcome::wrong : Outcome::right;
  } catch (const InputError& problem) {
    how.error = problem.what();
    return Outcome::fails;
  }
}

}  // namespace

std::string Searched::name() const {
  std::string name = file.stem().string();
  for (const auto& [parameter, value] : settings) name += fmt::format(" {}={}", parameter, value);
  return name;
}

namespace {

// Hard shadows: what is on the wrong side, beyond edges and the limit.
std::size_t wrong_hard(const scene::Scene& scene, const truth::Tracer& tracer,
                       const recipe::Limit& limit, const image::FloatImage& drawn,
                       const image::FloatImage& truth, const truth::SurfaceImage& surfaces) {
  // Edges cost sixteen times the truth, so that they are looked for where something is wrong alone.
  image::FloatImage edges = truth;
  std::fill(edges.values.begin(), edges.values.end(), 0.0f);
  if (truth::compare(drawn, truth, edges).wrong == 0) return 0;
  edges = tracer.edge_mask(scene.camera, scene.lights[0], drawn.width, drawn.height);
  return beyond_limit(scene, tracer, limit, drawn, truth, edges, surfaces);
}

}  // namespace

std::optional<std::size_t> wrong_beyond_limit(gl::Graphics& graphics, const Searched& searched,
                                              const Trial& trial) {
  recipe::Recipe recipe(graphics, searched.file, drawing_visibility());
  scene::Scene scene = scene_of(trial);
  set_up(recipe, searched, trial, scene);
  if (!recipe.holds()) return {};
  recipe.draw();
  const int width = graphics.width(), height = graphics.height();
  image::FloatImage drawn = visibility_of(graphics.frame.read_color());
  const truth::Tracer tracer(scene);
  const Claim claim = claim_of(recipe, searched.file);
  if (claim.soft()) {
    const auto points = recipe.points();
    if (points.empty()) {
      throw InputError(
          fmt::format("{} says of no points that it averages them (function points), so that "
                      "nothing exact can be said of its soft shadows",
                      searched.name()));
    }
    return wrong_average(scene, tracer, recipe.limit(), claim, points, drawn);
  }
  const scene::Light& light = scene.lights[0];
  const auto truth = tracer.visibility(scene.camera, light, width, height);
  const auto surfaces = tracer.surfaces(scene.camera, width, height);
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    const truth::Surface& surface = surfaces.surfaces[i];
    if (!claim.covers(scene, surface) || grazed(surface, light.position))
      drawn.values[i] = truth.values[i];
  }
  return wrong_hard(scene, tracer, recipe.limit(), drawn, truth, surfaces);
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

SearchResult search(const SearchOptions& options,
                    const std::function<void(const Progress&)>& progress,
                    const std::function<void(const Departure&)>& found) {
  Screens screens;
  SearchResult result;
  const double began = now_ms();
  for (; result.trials < options.trials; ++result.trials) {
    if (now_ms() - began > 1000 * options.most_seconds) break;
    const std::uint64_t index = options.first + result.trials;
    const Trial trial = trial_of(options.seed, index);
    if (progress) {
      progress(
          {result.trials, options.trials, fmt::format("{} departures", result.departures.size())});
    }
    for (const auto& recipe : options.recipes) {
      Departure departure{recipe.name(), index, trial, 0, ""};
      const Outcome outcome = outcome_of(screens, recipe, trial, departure);
      result.pictures += outcome != Outcome::outside;
      if (outcome == Outcome::outside || outcome == Outcome::right) continue;
      // What fails in every world is said once.
      const auto said = [&](const Departure& other) {
        return other.recipe == departure.recipe && other.error == departure.error;
      };
      if (outcome == Outcome::fails && std::ranges::any_of(result.departures, said)) continue;
      departure.trial = shrunk(trial, [&](const Trial& next) {
        Departure how{};
        return outcome_of(screens, recipe, next, how) == outcome;
      });
      outcome_of(screens, recipe, departure.trial, departure);
      if (found) found(departure);
      result.departures.push_back(std::move(departure));
    }
  }
  return result;
}

}  // namespace shadowlab::measure
