// What the commands that draw share: size, context, parameters, from their options to a recipe.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recipe/recipe.h"

namespace shadowlab::cli {

struct DrawOptions {
  std::string recipe;
  std::string size = "512x512";
  std::optional<std::string> scene;
  std::vector<std::string> settings;  ///< NAME=VALUE
  std::string context = "automatic";
};

/// Whether a command lets the user choose the context, or brings its own.
enum class Context { chosen, own };

/// RECIPE, --size, --scene, --set, --context.
void add_draw_options(CLI::App& command, DrawOptions& options, Context context = Context::chosen);

/// "NAME=VALUE" of --set. Throws InputError.
std::pair<std::string, std::string> parse_setting(const std::string& setting);

/// A context with a recipe in it, its parameters set; print goes to standard output.
class Session {
 public:
  explicit Session(const DrawOptions& options, recipe::Options recipe_options = {});
  gl::Graphics& graphics() { return *graphics_; }
  recipe::Recipe& recipe() { return *recipe_; }

 private:
  std::unique_ptr<gl::Graphics> graphics_;
  std::unique_ptr<recipe::Recipe> recipe_;
};

/// "512x384" or "512". Throws InputError.
std::pair<int, int> parse_size(const std::string& text);

/// The recipe's file: as given, or NAME for scripts/NAME.lua. Throws InputError with near names.
std::filesystem::path find_recipe(const std::string& given);

/// The recipes of scripts/, sorted.
std::vector<std::filesystem::path> all_recipes();

}  // namespace shadowlab::cli
