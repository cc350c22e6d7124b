// shadowlab measure: speed against error.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/progress.h"
#include "cli/session.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/version.h"
#include "measure/markdown.h"
#include "measure/page.h"
#include "measure/sweep.h"
#include "measure/table.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

struct MeasureCommand {
  std::vector<std::string> recipes, scenes;
  std::string folder = "measure";
  std::string size;
  std::string context = "automatic";
  bool quick = false, fresh = false, table = false;
  int rounds = 0;
  double radius = measure::SweepOptions{}.radius;
  double bar = measure::SweepOptions{}.bar;
};

const std::vector<std::string> usual_scenes{"room", "comb", "city", "cornell"};
const std::vector<std::string> quick_scenes{"room", "city"};
constexpr const char* usual_size = "256x256";
constexpr const char* quick_size = "128x128";

// The recipes that are held against a truth, but for the one that draws it.
std::vector<fs::path> measured_recipes(gl::Graphics& graphics, const fs::path& reference) {
  std::vector<fs::path> recipes;
  for (const fs::path& file : all_recipes()) {
    if (file.stem() == reference.stem()) continue;
    if (!recipe::Recipe(graphics, file).description().truth.empty()) recipes.push_back(file);
  }
  return recipes;
}

measure::SweepOptions options_of(const MeasureCommand& command, gl::Graphics& graphics) {
  measure::SweepOptions options;
  options.reference = find_recipe("truth");
  for (const std::string& name : command.recipes) options.recipes.push_back(find_recipe(name));
  if (options.recipes.empty()) options.recipes = measured_recipes(graphics, options.reference);
  for (const fs::path& recipe : options.recipes) {
    const auto same = [&](const fs::path& other) { return other.stem() == recipe.stem(); };
    if (std::count_if(options.recipes.begin(), options.recipes.end(), same) > 1)
      throw InputError(
          fmt::format("two recipes are called {}; rename one", recipe.stem().string()));
  }
  options.scenes = command.scenes;
  if (options.scenes.empty()) options.scenes = command.quick ? quick_scenes : usual_scenes;
  options.radius = command.radius;
  options.bar = command.bar;
  if (command.quick) {
    options.extent = measure::Extent::coarse;
    options.rounds = 2;
    options.milliseconds = 40;
    options.most_frames = 4;
    options.slow = 300;
    options.bar_check_size = 64;
  }
  const int side = std::min(graphics.width(), 2048);
  options.curves.side = side;
  options.curves.recipes = options.recipes;
  options.curves.scene = options.scenes[0];
  options.curves.lights = find_recipe("volumes_lights");
  if (command.quick) {
    options.curves.sides = {std::max(1, side / 2), side, 2 * side};
    options.curves.light_counts = {1, 2, 4};
    options.curves.milliseconds = 20;
    options.curves.rounds = 1;
  } else {
    options.curves.sides = {std::max(1, side / 2), side, 2 * side, 4 * side};
    options.curves.divisions = {16, 32, 64, 128};
    options.curves.light_counts = {1, 2, 4, 8};
  }
  if (command.rounds > 0) options.rounds = command.rounds;
  return options;
}

Answer run(const MeasureCommand& command) {
  const double began = now_ms();
  const std::string size = !command.size.empty() ? command.size
                           : command.quick       ? quick_size
                                                 : usual_size;
  const auto [width, height] = parse_size(size);
  const fs::path folder = command.folder;
  make_folder(folder);
  expect_writable(folder / "measure.json");
  if (command.fresh) fs::remove(folder / "journal.jsonl");
  gl::Graphics graphics(context::create(context::backend_named(command.context)), width, height);
  const measure::SweepOptions options = options_of(command, graphics);
  ProgressLine line;
  const measure::Json report =
      measure::sweep(graphics, options, folder, [&](const measure::Progress& progress) {
        line.show(progress.done, progress.all, progress.what);
      });
  line.clear();
  write_text(folder / "measure.json", report.dump(1) + "\n");
  write_text(folder / "measure.csv", measure::csv_of(report));
  write_text(folder / "measure.schema.json", measure::page_file("measure.schema.json"));
  write_text(folder / "report.html", measure::measure_page(report, folder));
  if (command.table) {
    fmt::print("{}", measure::markdown_of(report));
    return Answer::yes;
  }
  const auto& points = report.at("points");
  const auto left_out = std::count_if(points.begin(), points.end(),
                                      [](const auto& point) { return point.contains("left_out"); });
  fmt::print("{} points, {} of them left out, in {:.0f} s: {}\n", points.size(), left_out,
             (now_ms() - began) / 1000, (folder / "report.html").string());
  return Answer::yes;
}

}  // namespace

void add_measure(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("measure", "Speed against error, as CSV, JSON and a page");
  auto options = std::make_shared<MeasureCommand>();
  command
      ->add_option("recipes", options->recipes,
                   "Recipes; all that are held against a truth unless given")
      ->type_name("RECIPE");
  command
      ->add_option("--scene", options->scenes,
                   "Scenes; room, comb, city and cornell unless given; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option("-o,--output", options->folder,
                   "The folder of the report, and of what is kept to go on after an interruption")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag(
      "--quick", options->quick,
      "In a minute or so: two scenes, smaller pictures, the first three values of each sweep");
  command->add_flag("--fresh", options->fresh, "Begin again, whatever DIR holds of an earlier run");
  command->add_flag(
      "--table", options->table,
      "Print the report's figures as Markdown tables; at once, of a run that DIR has whole");
  command->add_option("--size", options->size, "Picture size in pixels; 256x256, quick 128x128")
      ->type_name("WxH");
  command->add_option("--rounds", options->rounds, "Rounds of frames; 3, quick 2")
      ->type_name("N")
      ->check(CLI::Range(1, 100));
  command->add_option("--radius", options->radius, "Radius of the light of soft recipes, metres")
      ->type_name("R")
      ->check(CLI::Range(0.001, 2.0))
      ->capture_default_str();
  command
      ->add_option("--bar", options->bar, "Standard error that the soft truth may have in a pixel")
      ->type_name("E")
      ->check(CLI::Range(0.0005, 0.1))
      ->capture_default_str();
  command
      ->add_option("--context", options->context, "osmesa, egl or glfw; else the first that works")
      ->type_name("CONTEXT");
  command->footer(
      "Each recipe is drawn with every value of its table sweep, in each scene, and held against "
      "the truth; then\nall are timed in turns. Interrupted, the same command goes on where it "
      "was.\n\nExample:\n  shadowlab measure volumes_zfail shadow_map_pcf --scene room -o out");
  command->callback([options, &answer] { answer = run(*options); });
}

}  // namespace shadowlab::cli
