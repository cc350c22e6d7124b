// shadowlab check: recipes against the exact truth.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "cli/commands.h"
#include "cli/session.h"
#include "core/error.h"
#include "core/version.h"
#include "image/image.h"
#include "measure/check.h"

namespace shadowlab::cli {
namespace {

struct CheckCommand {
  std::vector<std::string> recipes;
  std::vector<std::string> scenes;
  std::vector<std::string> settings;
  std::string size = "256x256";
  std::string context = "automatic";
  std::string pictures;
  int views = 1;
  std::uint64_t seed = 1;
  double nearest = measure::CheckOptions{}.nearest;
};

bool is_checked(gl::Graphics& graphics, const std::filesystem::path& recipe) {
  return !recipe::Recipe(graphics, recipe).description().truth.empty();
}

constexpr std::size_t most_views = 4;  // of one row that are named and drawn

// The wrong views, or the scene's own where none is wrong.
void write_pictures(gl::Graphics& graphics, const std::filesystem::path& recipe,
                    const measure::CheckOptions& options, const measure::CheckResult& row,
                    const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  auto views = row.wrong_views;
  if (views.empty()) views.emplace_back(0, 0);
  views.resize(std::min(most_views, views.size()));
  for (const auto& [view, wrong] : views) {
    image::write_png(folder / fmt::format("{}_{}_{}.png", row.recipe, row.scene, view),
                     measure::picture_of(graphics, recipe, options, view));
  }
}

// "33 (93 pixels), 71 (2)": the worst first.
std::string wrong_views(const measure::CheckResult& row) {
  if (row.wrong_views.empty()) return "-";
  std::string text;
  for (const auto& [view, wrong] :
       std::span(row.wrong_views).first(std::min(most_views, row.wrong_views.size()))) {
    text += text.empty() ? fmt::format("{} ({} pixels)", view, wrong)
                         : fmt::format(", {} ({})", view, wrong);
  }
  if (row.wrong_views.size() > most_views)
    text += fmt::format(" and {} more", row.wrong_views.size() - most_views);
  return text;
}

// Absent: the recipe's own. "all" stands for each of the catalogue.
std::vector<std::optional<std::string>> scenes_of(const CheckCommand& command) {
  if (command.scenes.empty()) return {std::nullopt};
  std::vector<std::optional<std::string>> scenes;
  for (const std::string& name : command.scenes) {
    if (name != "all") {
      scenes.emplace_back(name);
      continue;
    }
    for (const auto& file : std::filesystem::directory_iterator(home() / "scripts" / "scenes")) {
      if (file.path().extension() == ".lua") scenes.emplace_back(file.path().stem().string());
    }
  }
  std::ranges::sort(scenes);
  return scenes;
}

Answer check(const CheckCommand& command) {
  if (command.views < 1 || command.views > 100000)
    throw InputError("--views takes a number from 1 to 100000");
  const auto [width, height] = parse_size(command.size);
  gl::Graphics graphics(context::create(context::backend_named(command.context)), width, height);
  std::vector<std::filesystem::path> recipes;
  for (const std::string& name : command.recipes) recipes.push_back(find_recipe(name));
  if (recipes.empty()) {
    for (const auto& recipe : all_recipes()) {
      if (is_checked(graphics, recipe)) recipes.push_back(recipe);
    }
  }
  const auto scenes = scenes_of(command);

  Answer answer = Answer::yes;
  fmt::print("{:<24} {:<10} {:>6} {:>8} {:>11} {:>8} {:>12} {:>13} {:>9}  {}\n", "recipe", "scene",
             "views", "outside", "pixels", "wrong", "beyond edge", "beyond limit", "RMSE",
             "wrong views");
  for (const auto& recipe : recipes) {
    for (const auto& scene : scenes) {
      measure::CheckOptions options;
      options.scene = scene;
      options.views = command.views;
      options.seed = command.seed;
      options.nearest = command.nearest;
      for (const std::string& setting : command.settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
          throw InputError("--set takes NAME=VALUE; \"" + setting + "\" given");
        options.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
      }
      const auto row = measure::check(graphics, recipe, options);
      fmt::print("{:<24} {:<10} {:>6} {:>8} {:>11} {:>8} {:>12} {:>13} {:>9.6f}  {}\n", row.recipe,
                 row.scene, row.views, row.outside, row.pixels, row.wrong, row.wrong_beyond_edge,
                 row.wrong_beyond_limit, row.rmse, wrong_views(row));
      std::fflush(stdout);
      if (row.wrong_beyond_edge > 0) answer = Answer::no;
      if (!command.pictures.empty())
        write_pictures(graphics, recipe, options, row, command.pictures);
    }
  }
  return answer;
}

}  // namespace

void add_check(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("check", "Compare recipes with the exact truth");
  auto options = std::make_shared<CheckCommand>();
  command
      ->add_option("recipes", options->recipes,
                   "Recipes; all that are held against a truth unless given")
      ->type_name("RECIPE");
  command
      ->add_option(
          "--scene", options->scenes,
          "Scenes in place of the recipes' own; may be repeated; all for each of the catalogue")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--set", options->settings, "Set a parameter, as in --set light=2,4,1")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option("--views", options->views,
                   "The scene's own camera and light, and N-1 seeded random ones")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the random views")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--nearest", options->nearest,
                   "The nearest near plane of the random views, in radii of the casters")
      ->type_name("R")
      ->check(CLI::Range(1e-9, 0.3))
      ->capture_default_str();
  command->add_option("--size", options->size, "Picture size in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command
      ->add_option("--context", options->context, "osmesa, egl or glfw; else the first that works")
      ->type_name("CONTEXT");
  command
      ->add_option(
          "--pictures", options->pictures,
          "Write the worst views of each row into this folder: technique, truth, wrong pixels")
      ->type_name("DIR");
  command->footer(
      "Columns: views compared, and those outside of the technique's conditions; pixels compared; "
      "wrong\n"
      "ones; wrong ones farther than a pixel from a true edge, and those of them that the recipe's "
      "own limit\n(the rounding of its depths, its texels) does not explain; the RMSE of "
      "visibility. Ends with 1 "
      "where a\n"
      "pixel beyond an edge is wrong.\n\nExample: shadowlab check volumes_zfail --scene room "
      "--views 100");
  command->callback([options, &answer] { answer = check(*options); });
}

}  // namespace shadowlab::cli
