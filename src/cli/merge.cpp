// shadowlab merge: the folders of several shards as one.
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/labs.h"
#include "lab/formats.h"
#include "lab/run.h"

namespace shadowlab::cli {

void add_merge(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("merge", "Put the results of several shards together");
  struct Options {
    std::vector<std::string> folders;
    std::string out = "graded";
  };
  auto options = std::make_shared<Options>();
  command->add_option("folders", options->folders, "What shadowlab grade --shard wrote into")
      ->required()
      ->type_name("DIR…");
  command->add_option("-o,--out", options->out, "The folder for all")
      ->type_name("DIR")
      ->capture_default_str();
  command->footer("Example:\n  shadowlab merge shard1 shard2 -o graded");
  command->callback([options, &answer] {
    const std::vector<std::filesystem::path> folders(options->folders.begin(),
                                                     options->folders.end());
    const auto results = lab::merge(folders, options->out);
    const auto identity = lab::identity_of(options->out);
    write_class(options->out, results, identity.language);
    write_text(std::filesystem::path(options->out) / "results.json", lab::as_json(results));
    fmt::print("{} results in {}\n", results.size(), options->out);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
