// shadowlab stress: the numerically hard cases.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/progress.h"
#include "cli/session.h"
#include "core/error.h"
#include "core/version.h"
#include "measure/page.h"
#include "measure/search.h"
#include "measure/stress.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

struct StressCommand {
  std::vector<int> rows;
  std::string folder;
  std::uint64_t search = 0, seed = 1, first = 0;
  double seconds = 0;
  std::vector<std::string> recipes;
};

// Those that claim to be right wherever they hold, but for a limit that they state. Not
// volumes_zpass: its two draws with culled faces lose a count where rounding turns a sliver round;
// volumes_two_sided is the same without that. Of soft shadows those that average hard ones, each of
// which is right.
const std::vector<std::string> searched_recipes{"volumes_zfail",
                                                "volumes_auto",
                                                "volumes_two_sided",
                                                "volumes_gpu",
                                                "volumes_gpu:extruder=geometry",
                                                "planned",
                                                "shadow_map_exact",
                                                "shadow_map_copy",
                                                "shadow_map_fbo",
                                                "shadow_map_sampler",
                                                "shadow_map_pcf",
                                                "shadow_map_cube",
                                                "shadow_map_cascades",
                                                "shadow_map_stable",
                                                "room",
                                                "room_fast",
                                                "soft_accumulated",
                                                "soft_accumulated:technique=maps",
                                                "soft_parallelogram:samples=16"};

// NAME or NAME:PARAMETER=VALUE[:…].
measure::Searched searched(const std::string& words) {
  std::size_t end = words.find(':');
  measure::Searched searched{find_recipe(words.substr(0, end)), {}};
  while (end != std::string::npos) {
    const std::size_t begin = end + 1, equals = words.find('=', begin);
    end = words.find(':', begin);
    if (equals == std::string::npos || equals > end)
      throw InputError(fmt::format("--recipe takes NAME:PARAMETER=VALUE; \"{}\" given", words));
    searched.settings.emplace_back(words.substr(begin, equals - begin),
                                   words.substr(equals + 1, end - equals - 1));
  }
  return searched;
}

Answer search(const StressCommand& command) {
  measure::SearchOptions options;
  options.seed = command.seed;
  options.first = command.first;
  options.trials = command.search;
  if (command.seconds > 0) options.most_seconds = command.seconds;
  for (const auto& words : command.recipes.empty() ? searched_recipes : command.recipes)
    options.recipes.push_back(searched(words));
  ProgressLine line;
  const auto result = measure::search(
      options,
      [&](const measure::Progress& progress) {
        line.show(progress.done, progress.all, progress.what);
      },
      [&](const measure::Departure& departure) {
        line.clear();
        fmt::print("{}, world {}: {}\n{}\n", departure.recipe, departure.index,
                   departure.error.empty()
                       ? fmt::format("{} pixels are wrong beyond an edge and the technique's limit",
                                     departure.beyond_edge)
                       : departure.error,
                   measure::lua_of(departure.trial));
        std::fflush(stdout);
      });
  line.clear();
  fmt::print("{} worlds, {} pictures of {} recipes, {} departures\n", result.trials,
             result.pictures, options.recipes.size(), result.departures.size());
  return result.departures.empty() ? Answer::yes : Answer::no;
}

void print(const measure::StressRow& row) {
  fmt::print("{:>3}  {}  {}\n     expected   {}\n     listing    {}\n     shadowlab  {}\n",
             row.hard.number, row.passes() ? "pass" : "FAIL", row.hard.title, row.hard.expected,
             measure::naive_words(row), measure::our_words(row));
}

Answer run(const StressCommand& command) {
  if (command.search > 0) return search(command);
  const fs::path facts = home() / "tests" / "hard";
  if (!fs::is_directory(facts)) {
    throw MachineError(
        fmt::format("the hard cases are in {}, which is not there; take the whole "
                    "source of shadowlab",
                    facts.string()));
  }
  const fs::path folder = command.folder;
  if (!folder.empty()) {
    make_folder(folder);
    expect_writable(folder / "stress.json");
  }
  ProgressLine line;
  const auto rows = measure::stress(facts, command.rows, [&](const measure::Progress& progress) {
    line.show(progress.done, progress.all, progress.what);
  });
  line.clear();
  Answer answer = Answer::yes;
  for (const measure::StressRow& row : rows) {
    print(row);
    if (!row.passes()) answer = Answer::no;
  }
  if (folder.empty()) return answer;
  measure::Json records = measure::Json::array();
  for (const measure::StressRow& row : rows)
    records.push_back(measure::record_of(row, measure::write_pictures(row, folder)));
  write_text(folder / "stress.json", records.dump(1) + "\n");
  write_text(folder / "stress.csv", measure::stress_csv(records));
  write_text(folder / "stress.html", measure::stress_page(records, folder));
  fmt::print("{} rows: {}\n", rows.size(), (folder / "stress.html").string());
  return answer;
}

}  // namespace

void add_stress(CLI::App& app, Answer& answer) {
  CLI::App* command =
      app.add_subcommand("stress", "The numerically hard cases: expected, naive, shadowlab");
  auto options = std::make_shared<StressCommand>();
  command->add_option("rows", options->rows, "The rows' numbers; all unless given")->type_name("N");
  command
      ->add_option("-o,--output", options->folder,
                   "Write stress.csv, stress.json, stress.html and the pictures into this folder")
      ->type_name("DIR");
  command
      ->add_option("--search", options->search,
                   "Instead of the rows, look for departures from the truth in so many worlds "
                   "made at random")
      ->type_name("N");
  command
      ->add_option("--seconds", options->seconds, "Begin no world after so long; the rest are left")
      ->type_name("S");
  command->add_option("--seed", options->seed, "Seed of those worlds")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--first", options->first, "The first world's number")->type_name("N");
  command
      ->add_option(
          "--recipe", options->recipes,
          "A recipe to search with, and its parameters as in volumes_gpu:extruder=geometry; may be "
          "repeated; those that claim to be right everywhere unless given")
      ->type_name("RECIPE")
      ->allow_extra_args(false);
  command->footer(
      "Each row says what is exact, what the listing as a lecture prints it gives, and what "
      "shadowlab gives.\nEnds with 1 where a row fails.\n\nExample:\n  shadowlab stress 6 11 -o "
      "out/stress");
  command->callback([options, &answer] { answer = run(*options); });
}

}  // namespace shadowlab::cli
