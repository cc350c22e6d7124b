// What shadow maps cost. bench_maps prints what they are worth.
//
//   bench_map_costs [--quick] [ratios] [exact] [fill]
//
// ratios  of medians, things in turns: a map copied against one in a framebuffer, filters against
//         their taps, a cube's faces left out or not
// exact   the map without aliasing against shadow volumes, the same picture: under a still light,
//         whose grid is kept, and under one that moves in every frame
// fill    each pass against the fill limit of this machine; docs/figures.md explains what is over
//         1.5
//
// All where none is named. --quick: a smaller frame and fewer repetitions.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>

#include "core/version.h"
#include "measure/fill.h"
#include "measure/median.h"

namespace shadowlab {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::filesystem::path file_of(const std::string& recipe) {
  return home() / "scripts" / (recipe + ".lua");
}

// ---- costs, as ratios within one run

// A recipe set one way, and the milliseconds of its frames' passes that a test picks.
class Timed {
 public:
  using Pick = std::function<bool(const std::string&)>;
  Timed(gl::Graphics& graphics, const std::string& name, const std::string& scene,
        const Settings& settings, Pick pick)
      : recipe_(graphics, file_of(name), timed_in(scene)), pick_(std::move(pick)) {
    for (const auto& [key, value] : settings) recipe_.set(key, value);
    recipe_.draw();
  }

  recipe::Recipe& recipe() { return recipe_; }
  void draw() {
    recipe_.draw();
    double sum = 0;
    for (const auto& pass : recipe_.passes()) {
      if (pick_(pass.name)) sum += pass.milliseconds;
    }
    times_.push_back(sum);
  }
  void forget() { times_.clear(); }
  double ms() const { return measure::median(times_); }

 private:
  static recipe::Options timed_in(const std::string& scene) {
    recipe::Options options;
    options.scene = scene;
    options.time_passes = true;
    return options;
  }
  recipe::Recipe recipe_;
  Pick pick_;
  std::vector<double> times_;
};

bool is_first(const std::string& pass) { return pass.starts_with("1."); }
bool is_second(const std::string& pass) { return pass.starts_with("2."); }

void in_turns(std::vector<std::unique_ptr<Timed>>& things, int frames) {
  for (int i = 0; i < frames; ++i) {
    for (auto& thing : things) thing->draw();
  }
}

void copies(gl::Graphics& graphics, int frames) {
  fmt::print("The map's pass in table, a frame of {0} x {0}: copied, over drawn in a framebuffer\n",
             graphics.width());
  for (const std::string size : {"256", "512", "1024", "2048"}) {
    std::vector<std::unique_ptr<Timed>> things;
    for (const std::string name : {"shadow_map_copy", "shadow_map_fbo"}) {
      things.push_back(
          std::make_unique<Timed>(graphics, name, "table", Settings{{"size", size}}, is_first));
      things.back()->recipe().set_light(glm::dvec4(2, 4, 1, 0));
    }
    in_turns(things, frames);
    fmt::print("  map {:>4}^2: copied {:8.3f} ms, framebuffer {:8.3f} ms, ratio {:.2f}\n", size,
               things[0]->ms(), things[1]->ms(), things[0]->ms() / things[1]->ms());
  }
  fmt::print("\n");
}

void taps(gl::Graphics& graphics, int frames) {
  fmt::print("The scene's pass in table under n x n taps, over that of one tap\n");
  const std::vector<double> numbers{1, 2, 3, 4, 6, 8};
  for (const std::string hardware : {"false", "true"}) {
    std::vector<std::unique_ptr<Timed>> things;
    for (const double number : numbers) {
      const Settings settings{{"number", fmt::format("{}", number)}, {"hardware", hardware}};
      things.push_back(
          std::make_unique<Timed>(graphics, "shadow_map_pcf", "table", settings, is_second));
    }
    in_turns(things, frames);
    const double one = things[0]->ms();
    fmt::print("  {}:", hardware == "true" ? "each 2 x 2 by the sampler" : "each one texel");
    for (std::size_t i = 0; i < numbers.size(); ++i)
      fmt::print("  {:.0f} taps {:.2f}", numbers[i] * numbers[i], things[i]->ms() / one);
    const double more = things.back()->ms() - one;
    fmt::print("; a tap adds {:.3f} of one's frame ({:.2f} ms)\n", more / 63 / one, one);
  }
  fmt::print("\n");
}

void faces(gl::Graphics& graphics, int frames) {
  fmt::print(
      "The cube's faces, drawn anew each frame: all six, over those with a shadow that is seen\n");
  for (const std::string scene : {"room", "cornell", "table", "comb"}) {
    std::vector<std::unique_ptr<Timed>> things;
    for (const std::string cull : {"false", "true"}) {
      const Settings settings{{"keep", "false"}, {"cull", cull}};
      things.push_back(
          std::make_unique<Timed>(graphics, "shadow_map_cube", scene, settings, is_first));
    }
    in_turns(things, frames);
    const auto passes = things[1]->recipe().passes();
    const auto left_out = std::count_if(passes.begin(), passes.end(), [](const auto& pass) {
      return pass.name.find("no shadow there is seen") != std::string::npos;
    });
    fmt::print("  {:<8} {} of 6 left out: {:8.3f} ms against {:8.3f} ms, ratio {:.2f}\n", scene,
               left_out, things[0]->ms(), things[1]->ms(), things[0]->ms() / things[1]->ms());
  }
  fmt::print("\n");
}

void ratios_table(bool quick) {
  gl::Graphics graphics(context::create(), 512, 512);
  const int frames = quick ? 5 : 15;
  copies(graphics, frames);
  taps(graphics, frames);
  faces(graphics, frames);
}

// ---- the map without aliasing against volumes

bool is_any(const std::string&) { return true; }

struct Against {
  double exact, volumes;
};

Against exact_against_volumes(gl::Graphics& graphics, const std::string& scene, bool moving,
                              int frames) {
  std::vector<std::unique_ptr<Timed>> things;
  // A grid that is kept may be fine.
  const Settings cells{{"cells", moving ? "128" : "512"}};
  things.push_back(std::make_unique<Timed>(graphics, "shadow_map_exact", scene, cells, is_any));
  things.push_back(std::make_unique<Timed>(graphics, "volumes_zfail", scene, Settings{}, is_any));
  const glm::dvec4 light = things[0]->recipe().light();
  for (auto& thing : things) thing->forget();
  for (int i = 0; i < frames; ++i) {
    for (auto& thing : things) {
      if (moving) thing->recipe().set_light(light + glm::dvec4(0.001 * (i + 1), 0, 0, 0));
      thing->draw();
    }
  }
  return {things[0]->ms(), things[1]->ms()};
}

void exact_table(bool quick) {
  const int size = quick ? 256 : 512;
  gl::Graphics graphics(context::create(), size, size);
  fmt::print("The map without aliasing against volumes_zfail, frames of {0} x {0}, ms\n", size);
  fmt::print("{:<9} {:>9} {:>9} {:>9} {:>7} {:>9} {:>9} {:>7}\n", "scene", "triangles", "exact",
             "volumes", "ratio", "moving", "volumes", "ratio");
  std::vector<std::string> scenes;
  for (const auto& file : std::filesystem::directory_iterator(home() / "scripts" / "scenes"))
    scenes.push_back(file.path().stem().string());
  std::ranges::sort(scenes);
  for (const std::string& scene : scenes) {
    recipe::Options options;
    options.scene = scene;
    const recipe::Recipe counted(graphics, file_of("shadow_map_exact"), options);
    std::size_t triangles = 0;
    for (const auto& object : counted.scene()->objects)
      triangles += object.casts() ? object.mesh->triangle_count() : 0;
    const Against still = exact_against_volumes(graphics, scene, false, quick ? 3 : 7);
    const Against moving = exact_against_volumes(graphics, scene, true, quick ? 3 : 7);
    fmt::print("{:<9} {:>9} {:>9.1f} {:>9.1f} {:>7.2f} {:>9.1f} {:>9.1f} {:>7.2f}\n", scene,
               triangles, still.exact, still.volumes, still.exact / still.volumes, moving.exact,
               moving.volumes, moving.exact / moving.volumes);
    std::fflush(stdout);
  }
  fmt::print("\n");
}

// ---- passes against the fill limit

void fill_table(bool quick) {
  const int size = quick ? 256 : 512;
  gl::Graphics graphics(context::create(), size, size);
  const auto limit = measure::fill_limit(graphics);
  fmt::print("a layer of 1 Mpix, ms:");
  for (std::size_t kind = 0; kind < measure::layer_count; ++kind)
    fmt::print("  {} {:.2f}", measure::name_of(static_cast<measure::Layer>(kind)),
               limit.layer[kind]);
  fmt::print("\na small triangle, ns: {:.0f}; a pass, ms: {:.3f}\n", limit.triangle, limit.pass);
  fmt::print("\n{:<10} {:<44} {:>7} {:>9} {:>8} {:>8} {:>6} {:>7}\n", "recipe", "pass", "Mpix",
             "triangles", "least ms", "ms", "fill", "in all");
  for (const std::string name : {"copy", "fbo", "sampler", "pcf", "cube", "cascades", "stable",
                                 "moments", "pcss", "exact"}) {
    recipe::Options options;
    options.time_passes = true;
    recipe::Recipe recipe(graphics, file_of("shadow_map_" + name), std::move(options));
    if (name == "cube") recipe.set("keep", "false");
    for (const auto& pass : measure::fill_of(graphics, recipe, quick ? 3 : 9)) {
      const double least = pass.least(limit);
      fmt::print("{:<10} {:<44.44} {:>7.3f} {:>9} {:>8.3f} {:>8.3f} {:>6.2f} {:>7.2f}\n", name,
                 pass.name, pass.covered(), pass.triangles, least, pass.milliseconds,
                 least > 0 ? pass.milliseconds / least : 0,
                 least > 0 ? pass.milliseconds / pass.least_in_all(limit) : 0);
    }
    std::fflush(stdout);
  }
  fmt::print("\n");
}

}  // namespace
}  // namespace shadowlab

int main(int count, char** arguments) {
  using namespace shadowlab;
  std::set<std::string> words(arguments + 1, arguments + count);
  const bool quick = words.erase("--quick") > 0;
  const auto wanted = [&](const char* part) { return words.empty() || words.contains(part); };
  if (wanted("ratios")) ratios_table(quick);
  if (wanted("exact")) exact_table(quick);
  if (wanted("fill")) fill_table(quick);
}
