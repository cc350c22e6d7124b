// shadowlab run: a recipe becomes a picture.
#include <fmt/format.h>

#include <chrono>

#include "cli/captures.h"
#include "cli/commands.h"
#include "cli/session.h"
#include "core/error.h"
#include "image/image.h"

namespace shadowlab::cli {
namespace {

struct RunOptions {
  DrawOptions draw;
  std::string output;
  int frames = 1;
  std::string captures;
  bool timings = false;
};

constexpr double frames_per_second = 60;  // the clock that r.time follows

void print_timings(const recipe::Recipe& recipe) {
  std::size_t widest = 5;
  double all = 0;
  for (const auto& pass : recipe.passes()) {
    widest = std::max(widest, pass.name.size());
    all += pass.milliseconds;
  }
  fmt::print("{:<{}}  {:>9}  {:>5}\n", "pass", widest, "ms", "share");
  for (const auto& pass : recipe.passes()) {
    fmt::print("{:<{}}  {:>9.3f}  {:>4.0f}%\n", pass.name, widest, pass.milliseconds,
               all > 0 ? 100 * pass.milliseconds / all : 0);
  }
  fmt::print("{:<{}}  {:>9.3f}\n", "frame", widest, all);
}

void run(const RunOptions& options) {
  if (options.frames < 1 || options.frames > 100000)
    throw InputError("--frames takes a number from 1 to 100000");
  recipe::Options recipe_options;
  recipe_options.time_passes = options.timings;
  Session session(options.draw, std::move(recipe_options));
  std::optional<Captures> captures;
  for (int frame = 0; frame < options.frames; ++frame) {
    const bool last = frame + 1 == options.frames;
    if (last && !options.captures.empty()) captures.emplace(options.captures, session);
    session.recipe().draw(frame / frames_per_second);
  }
  if (captures) captures->finish();
  const auto output = options.output.empty()
                          ? std::filesystem::path(options.draw.recipe).stem().string() + ".png"
                          : options.output;
  image::write_png(output, session.graphics().frame.read_color());
  if (options.timings) print_timings(session.recipe());
}

}  // namespace

void add_run(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("run", "Draw a recipe into a PNG");
  auto options = std::make_shared<RunOptions>();
  add_draw_options(*command, options->draw);
  command->add_option("-o,--output", options->output, "The picture; RECIPE.png unless given")
      ->type_name("OUT.png");
  command
      ->add_option("--frames", options->frames,
                   "Draw this many frames and keep the last; r.time advances by 1/60 s")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--captures", options->captures,
                   "Write colour, depth and stencil after each pass into this folder")
      ->type_name("DIR");
  command->add_flag("--timings", options->timings, "Print the time of each pass");
  command->callback([options, &answer] {
    run(*options);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
