// shadowlab run: a recipe becomes a picture.
#include <fmt/format.h>

#include <cstdio>

#include "cli/captures.h"
#include "cli/commands.h"
#include "cli/explain.h"
#include "cli/files.h"
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
  bool explain = false;
  bool plan = false;
};

constexpr double frames_per_second = 60;  // the clock that r.time follows

void print_timings(const recipe::Recipe& recipe, std::FILE* to) {
  std::size_t widest = 5;
  double all = 0;
  for (const auto& pass : recipe.passes()) {
    widest = std::max(widest, pass.name.size());
    all += pass.milliseconds;
  }
  fmt::print(to, "{:<{}}  {:>9}  {:>5}\n", "pass", widest, "ms", "share");
  for (const auto& pass : recipe.passes()) {
    fmt::print(to, "{:<{}}  {:>9.3f}  {:>4.0f}%\n", pass.name, widest, pass.milliseconds,
               all > 0 ? 100 * pass.milliseconds / all : 0);
  }
  fmt::print(to, "{:<{}}  {:>9.3f}\n", "frame", widest, all);
}

// Where the picture goes: as given, - for standard output, else beside us under the recipe's name.
std::filesystem::path picture_of(const RunOptions& options) {
  if (options.output == "-") return "/dev/stdout";
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.draw.recipe).stem() += ".png";
}

// The session outlives the run, so that the end of the process takes it back at once.
std::unique_ptr<Session> run(const RunOptions& options) {
  if (options.frames < 1 || options.frames > 100000)
    throw InputError("--frames takes a number from 1 to 100000");
  const auto output = picture_of(options);
  expect_writable(output);
  if (!options.captures.empty()) make_folder(options.captures);
  // Where the picture is on standard output, nothing else may be.
  std::FILE* const words = options.output == "-" ? stderr : stdout;
  recipe::Options recipe_options;
  recipe_options.time_passes = options.timings;
  recipe_options.explain = options.explain;
  if (options.plan) recipe_options.casters = recipe::Options::Casters::planned;
  recipe_options.print = [words](std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), words);
  };
  auto kept = std::make_unique<Session>(options.draw, std::move(recipe_options));
  Session& session = *kept;
  std::optional<Captures> captures;
  for (int frame = 0; frame < options.frames; ++frame) {
    const bool last = frame + 1 == options.frames;
    if (last && !options.captures.empty()) captures.emplace(options.captures, session);
    session.recipe().draw(frame / frames_per_second);
  }
  if (captures) captures->finish();
  write_picture(output, session.graphics().frame.read_color());
  if (options.explain) print_explanation(session, words);
  if (options.timings) print_timings(session.recipe(), words);
  return kept;
}

}  // namespace

void add_run(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("run", "Draw a recipe into a PNG");
  auto options = std::make_shared<RunOptions>();
  add_draw_options(*command, options->draw);
  command
      ->add_option("-o,--output", options->output,
                   "The picture; RECIPE.png unless given, - for standard output")
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
  command->add_flag("--timings", options->timings,
                    "Print the time of each pass of the last frame, between two glFinish");
  command->add_flag(
      "--explain", options->explain,
      "Print what each pass of the last frame drew, and each decision with its reason");
  command->add_flag(
      "--plan", options->plan,
      "Leave out what changes no pixel: volumes and casters of maps whose shadows reach "
      "nothing that is seen; --explain says what was saved");
  command->footer(
      "Example:\n  shadowlab run projected_stencil -o out.png --set light=1,3,2 --captures passes");
  auto session = std::make_shared<std::unique_ptr<Session>>();
  command->callback([options, session, &answer] {
    *session = run(*options);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
