#include "cli/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "core/error.h"
#include "core/near_names.h"
#include "core/version.h"

namespace shadowlab::cli {

void add_draw_options(CLI::App& command, DrawOptions& options, Context context) {
  command
      .add_option("recipe", options.recipe,
                  "The recipe: a Lua file, or the name of one of scripts/")
      ->required()
      ->type_name("RECIPE");
  command.add_option("--size", options.size, "Picture size in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command.add_option("--scene", options.scene, "A scene in place of the recipe's own")
      ->type_name("NAME");
  command.add_option("--set", options.settings, "Set a parameter, as in --set light=2,4,1")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  if (context == Context::own) return;
  command
      .add_option("--context", options.context, "osmesa, egl or glfw; else the first that works")
      ->type_name("CONTEXT");
}

std::pair<int, int> parse_size(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  auto [after, error] = std::from_chars(text.data(), end, width);
  bool good = error == std::errc();
  if (good && after == end) {
    height = width;
  } else {
    good = good && (*after == 'x' || *after == 'X');
    if (good) {
      const auto second = std::from_chars(after + 1, end, height);
      good = second.ec == std::errc() && second.ptr == end;
    }
  }
  if (!good || width < 1 || height < 1 || width > 16384 || height > 16384) {
    throw InputError(
        fmt::format("--size takes WIDTHxHEIGHT in pixels, 1x1 to 16384x16384; \"{}\" given", text));
  }
  return {width, height};
}

std::vector<std::filesystem::path> all_recipes() {
  std::vector<std::filesystem::path> recipes;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts")) {
    if (entry.path().extension() == ".lua") recipes.push_back(entry.path());
  }
  std::sort(recipes.begin(), recipes.end());
  return recipes;
}

std::filesystem::path find_recipe(const std::string& given) {
  std::error_code error;
  if (std::filesystem::is_regular_file(given, error)) return given;
  const bool is_name = given.find('/') == std::string::npos && !given.ends_with(".lua");
  std::vector<std::string> stems;
  for (const auto& file : all_recipes()) {
    if (is_name && file.stem() == given)
      return file.lexically_proximate(std::filesystem::current_path());
    stems.push_back(file.stem().string());
  }
  const std::vector<std::string_view> names(stems.begin(), stems.end());
  const std::string stem = std::filesystem::path(given).stem().string();
  const std::string what =
      std::filesystem::is_directory(given, error) ? "is a folder" : "does not exist";
  throw InputError(fmt::format("{} {}{}", given, what, did_you_mean(stem, names)));
}

std::pair<std::string, std::string> parse_setting(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos) {
    throw InputError(
        fmt::format("--set takes NAME=VALUE, as in --set light=2,4,1; \"{}\" given", setting));
  }
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

Session::Session(const DrawOptions& options, recipe::Options recipe_options) {
  const auto [width, height] = parse_size(options.size);
  const auto file = find_recipe(options.recipe);
  const auto backend = context::backend_named(options.context);
  graphics_ = std::make_unique<gl::Graphics>(context::create(backend), width, height);
  if (options.scene) recipe_options.scene = options.scene;
  if (!recipe_options.print) {
    recipe_options.print = [](std::string_view text) {
      std::fwrite(text.data(), 1, text.size(), stdout);
    };
  }
  recipe_ = std::make_unique<recipe::Recipe>(*graphics_, file, std::move(recipe_options));
  for (const std::string& setting : options.settings) {
    const auto [name, value] = parse_setting(setting);
    recipe_->set(name, value);
  }
}

}  // namespace shadowlab::cli
