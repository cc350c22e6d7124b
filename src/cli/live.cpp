// shadowlab live: a recipe in a window, drawn again whenever it is saved.
#include "live/live_window.h"

#include <fmt/format.h>

#include <cstdio>

#include "cli/commands.h"
#include "cli/session.h"
#include "core/error.h"

namespace shadowlab::cli {
namespace {

struct LiveCommand {
  DrawOptions draw;
  double longest_frame = 4;  // seconds
  std::vector<std::string> others;
};

void run(const LiveCommand& command) {
  live::LiveOptions options;
  std::tie(options.width, options.height) = parse_size(command.draw.size);
  options.studio.recipes.push_back(find_recipe(command.draw.recipe));
  for (const std::string& other : command.others)
    options.studio.recipes.push_back(find_recipe(other));
  for (const std::string& setting : command.draw.settings)
    options.studio.settings.push_back(parse_setting(setting));
  options.studio.recipe.scene = command.draw.scene;
  options.studio.recipe.limits.seconds = command.longest_frame;
  options.studio.recipe.time_passes = true;
  options.studio.recipe.print = [](std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  };
  live::show(options);
}

}  // namespace

void add_live(CLI::App& app, Answer& answer) {
  CLI::App* command =
      app.add_subcommand("live", "A window that draws a recipe and follows it while it is edited");
  auto options = std::make_shared<LiveCommand>();
  add_draw_options(*command, options->draw, Context::own);
  command
      ->add_option("others", options->others, "More recipes, beside it with its camera and light")
      ->type_name("RECIPE");
  command
      ->add_option("--limit", options->longest_frame,
                   "A frame that takes longer is stopped, and is an error")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->footer("Example:\n  shadowlab live my_shadow.lua\nF1 in the window shows its keys.");
  command->callback([options, &answer] {
    run(*options);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
