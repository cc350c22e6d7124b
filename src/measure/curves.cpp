#include "measure/curves.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/clock.h"
#include "core/error.h"

namespace shadowlab::measure {
namespace {

namespace fs = std::filesystem;

std::optional<double> number(const std::string& text) {
  std::size_t read = 0;
  try {
    const double value = std::stod(text, &read);
    if (read == text.size()) return value;
  } catch (const std::exception&) {
  }
  return {};
}

// A frame's milliseconds: the median of those that fit.
double frame_time(gl::Graphics& graphics, recipe::Recipe& recipe, double milliseconds) {
  recipe.draw();
  graphics.gl.Finish.unrecorded();
  std::vector<double> times;
  const double end = now_ms() + milliseconds;
  do {
    const double began = now_ms();
    recipe.draw();
    graphics.gl.Finish.unrecorded();
    times.push_back(now_ms() - began);
  } while (now_ms() < end);
  return quantile(std::move(times), 0.5);
}

scene::Scene sphere_on_floor(int divisions) {
  scene::Scene scene;
  scene.name = "sphere";
  scene.camera.eye = {0.4, 2.6, 4.2};
  scene.camera.target = {0, 0.5, 0};
  const auto add = [&](const char* name, scene::Mesh mesh, double height, scene::Role role) {
    scene::Object object;
    object.name = name;
    object.mesh = std::make_shared<scene::Mesh>(std::move(mesh));
    object.model[3].y = height;
    object.role = role;
    scene.objects.push_back(std::move(object));
  };
  add("floor", scene::plane(6, 6), 0, scene::Role::receiver);
  add("sphere", scene::sphere(0.7, 2 * divisions, divisions + 1), 0.9, scene::Role::caster);
  scene.lights.emplace_back();
  scene.lights[0].position = {1.6, 4.0, 1.2, 1};
  return scene;
}

// One point of a curve: what is varied, and how a recipe is made for it.
struct PlannedPoint {
  double x = 0;
  int side = 0;
  std::function<std::unique_ptr<recipe::Recipe>(gl::Graphics&)> make;
};

struct Plan {
  Curve curve;
  std::vector<PlannedPoint> points;
};

std::unique_ptr<recipe::Recipe> made(gl::Graphics& graphics, const fs::path& file,
                                     std::optional<std::string> scene) {
  recipe::Options options;
  options.scene = std::move(scene);
  return std::make_unique<recipe::Recipe>(graphics, file, std::move(options));
}

std::vector<Plan> plans_of(const CurveOptions& options) {
  std::vector<Plan> plans;
  for (const fs::path& file : options.recipes) {
    Plan pixels{{file.stem().string(), options.scene, "pixels", {}}, {}};
    for (const int side : options.sides) {
      pixels.points.push_back({double(side) * side, side, [=](gl::Graphics& graphics) {
                                 return made(graphics, file, options.scene);
                               }});
    }
    plans.push_back(std::move(pixels));
    Plan triangles{{file.stem().string(), "sphere", "triangles", {}}, {}};
    for (const int divisions : options.divisions) {
      triangles.points.push_back(
          {4.0 * divisions * divisions, options.side, [=](gl::Graphics& graphics) {
             auto recipe = made(graphics, file, {});
             scene::Scene scene = sphere_on_floor(divisions);
             recipe->set_light(scene.lights[0].position);
             recipe->set_scene(std::move(scene));
             return recipe;
           }});
    }
    plans.push_back(std::move(triangles));
  }
  Plan lights{{options.lights.stem().string(), "sphere", "lights", {}}, {}};
  for (const int count : options.light_counts) {
    lights.points.push_back({double(count), options.side, [=](gl::Graphics& graphics) {
                               auto recipe = made(graphics, options.lights, {});
                               scene::Scene scene = sphere_on_floor(16);
                               scene.lights.resize(static_cast<std::size_t>(count));
                               for (int i = 0; i < count; ++i) {
                                 const double turn = 2 * 3.141592653589793 * i / count;
                                 scene.lights[static_cast<std::size_t>(i)].position = {
                                     2 * std::cos(turn), 4, 2 * std::sin(turn), 1};
                               }
                               recipe->set_scene(std::move(scene));
                               return recipe;
                             }});
  }
  plans.push_back(std::move(lights));
  return plans;
}

}  // namespace

Json record_of(const Curve& curve) {
  Json points = Json::array();
  for (const Point& point : curve.points) points.push_back({{"x", point.x}, {"ms", point.y}});
  const auto law = power_law(curve.points);
  return {{"recipe", curve.recipe},
          {"scene", curve.scene},
          {"of", curve.of},
          {"exponent", law ? Json(law->exponent) : Json()},
          {"explained", law ? Json(law->explained) : Json()},
          {"points", std::move(points)}};
}

std::vector<Curve> swept_curves(const Json& points) {
  // By recipe, scene and parameter, then by the others' values; of those the last is kept.
  std::map<std::array<std::string, 3>, std::map<std::string, Curve>> families;
  std::map<std::array<std::string, 3>, std::string> last;
  for (const Json& point : points) {
    if (point.contains("left_out") || point.at("planned").get<bool>()) continue;
    for (const auto& [name, text] : point.at("settings").items()) {
      const auto x = number(text.get<std::string>());
      if (!x) continue;
      std::string others;
      for (const auto& [other, value] : point.at("settings").items()) {
        if (other != name) others += " " + other + "=" + value.get<std::string>();
      }
      const std::array<std::string, 3> key{point.at("recipe").get<std::string>(),
                                           point.at("scene").get<std::string>(), name};
      Curve& curve = families[key][others];
      curve.recipe = key[0] + others;
      curve.scene = key[1];
      curve.of = name;
      curve.points.push_back({*x, point.at("frame_ms").at("median").get<double>()});
      last[key] = others;
    }
  }
  std::vector<Curve> curves;
  curves.reserve(families.size());
  for (auto& [key, family] : families) curves.push_back(std::move(family.at(last.at(key))));
  return curves;
}

std::size_t steps_of(const CurveOptions& options) {
  return options.recipes.size() * (options.sides.size() + options.divisions.size()) +
         options.light_counts.size();
}

std::vector<Curve> timed_curves(const CurveOptions& options, context::Backend backend,
                                Journal& journal, const std::function<void(std::string)>& step) {
  std::map<int, std::unique_ptr<gl::Graphics>> contexts;
  std::vector<Curve> curves;
  for (Plan& plan : plans_of(options)) {
    for (const PlannedPoint& point : plan.points) {
      const std::string key =
          fmt::format("curve {} {} {}", plan.curve.recipe, plan.curve.of, point.x);
      step(fmt::format("{}, {} {}", plan.curve.recipe, point.x, plan.curve.of));
      auto record = journal.find(key);
      if (!record) {
        auto& graphics = contexts[point.side];
        if (!graphics) {
          graphics =
              std::make_unique<gl::Graphics>(context::create(backend), point.side, point.side);
        }
        graphics->context().make_current();
        Json ms;
        try {
          std::vector<double> rounds;
          for (int round = 0; round < options.rounds; ++round) {
            const auto recipe = point.make(*graphics);
            if (!recipe->holds()) break;
            rounds.push_back(frame_time(*graphics, *recipe, options.milliseconds));
          }
          if (!rounds.empty()) ms = quantile(std::move(rounds), 0.5);
        } catch (const InputError&) {  // it cannot draw this, and has no point here
        }
        journal.write(key, ms);
        record = ms;
      }
      if (record->is_number()) plan.curve.points.push_back({point.x, record->get<double>()});
    }
    if (!plan.curve.points.empty()) curves.push_back(std::move(plan.curve));
  }
  for (auto& [side, graphics] : contexts) {
    graphics->context().make_current();
    graphics.reset();
  }
  return curves;
}

}  // namespace shadowlab::measure
