// shadowlab worker: the process that draws submissions. Graders start it (lab/worker.h); for people
// it is none.
#include <memory>

#include "cli/commands.h"
#include "cli/session.h"
#include "core/error.h"
#include "lab/zygote.h"

namespace shadowlab::cli {

void add_worker(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("worker", "Draw what a grader asks for");
  command->group("");  // --help does not list it
  struct Options {
    std::string size = "256x256", context = "automatic";
    bool namespaces = false, states = false;
    std::vector<std::filesystem::path> warm;
  };
  auto options = std::make_shared<Options>();
  command->add_option("--size", options->size)->type_name("WxH");
  command->add_option("--context", options->context)->type_name("CONTEXT");
  command->add_flag("--namespaces", options->namespaces, "It was started in its own");
  command->add_flag("--states", options->states, "Warm up with the lectures' states too");
  command->add_option("warm", options->warm)->type_name("RECIPE");
  command->callback([options, &answer] {
    const auto [width, height] = parse_size(options->size);
    lab::serve({.width = width,
                .height = height,
                .backend = context::backend_named(options->context),
                .namespaces = options->namespaces,
                .warm = options->warm,
                .warmth = options->states ? lab::Warmth::states : lab::Warmth::recipes});
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
