// shadowlab check: recipes against the exact truth.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/session.h"
#include "core/error.h"
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
};

bool is_checked(gl::Graphics& graphics, const std::filesystem::path& recipe) {
  return !recipe::Recipe(graphics, recipe).description().truth.empty();
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
  std::vector<std::optional<std::string>> scenes(command.scenes.begin(), command.scenes.end());
  if (scenes.empty()) scenes.emplace_back();

  Answer answer = Answer::yes;
  fmt::print("{:<24} {:<10} {:>6} {:>8} {:>11} {:>8} {:>12} {:>9}  {}\n", "recipe", "scene",
             "views", "outside", "pixels", "wrong", "beyond edge", "RMSE", "worst view");
  for (const auto& recipe : recipes) {
    for (const auto& scene : scenes) {
      measure::CheckOptions options;
      options.scene = scene;
      options.views = command.views;
      options.seed = command.seed;
      for (const std::string& setting : command.settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
          throw InputError("--set takes NAME=VALUE; \"" + setting + "\" given");
        options.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
      }
      const auto row = measure::check(graphics, recipe, options);
      fmt::print("{:<24} {:<10} {:>6} {:>8} {:>11} {:>8} {:>12} {:>9.6f}  {}\n", row.recipe,
                 row.scene, row.views, row.outside, row.pixels, row.wrong, row.wrong_beyond_edge,
                 row.rmse,
                 row.worst_wrong > 0 ? fmt::format("{} ({} wrong)", row.worst_view, row.worst_wrong)
                                     : "-");
      std::fflush(stdout);
      if (row.wrong_beyond_edge > 0) answer = Answer::no;
      if (!command.pictures.empty()) {
        std::filesystem::create_directories(command.pictures);
        image::write_png(std::filesystem::path(command.pictures) /
                             fmt::format("{}_{}_{}.png", row.recipe, row.scene, row.worst_view),
                         measure::picture_of(graphics, recipe, options, row.worst_view));
      }
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
      ->add_option("--scene", options->scenes,
                   "Scenes in place of the recipes' own; may be repeated")
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
  command->add_option("--size", options->size, "Picture size in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command
      ->add_option("--context", options->context, "osmesa, egl or glfw; else the first that works")
      ->type_name("CONTEXT");
  command
      ->add_option(
          "--pictures", options->pictures,
          "Write the worst view of each row into this folder: technique, truth, wrong pixels")
      ->type_name("DIR");
  command->footer(
      "Columns: views compared, and those outside of the technique's conditions; pixels compared; "
      "wrong\n"
      "ones; wrong ones farther than a pixel from a true edge; the RMSE of visibility. Ends with 1 "
      "where a\n"
      "pixel beyond an edge is wrong.\n\nExample: shadowlab check volumes_zfail --scene room "
      "--views 100");
  command->callback([options, &answer] { answer = check(*options); });
}

}  // namespace shadowlab::cli
