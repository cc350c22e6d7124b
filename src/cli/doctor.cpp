// shadowlab doctor: what this machine has, and what to install.
#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <thread>

#include "cli/commands.h"
#include "cli/session.h"
#include "context/context.h"
#include "core/error.h"
#include "core/version.h"
#include "lab/worker.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

using Row = std::array<std::string, 8>;

std::string bits(bool works, int count) {
  return works ? (count > 0 ? fmt::format("{}", count) : "none") : "";
}

Row row_of(const context::Report& report) {
  return {report.name,
          report.works ? "yes" : "no",
          bits(report.works, report.depth_bits),
          bits(report.works, report.stencil_bits),
          bits(report.works, report.accum_bits),
          report.package,
          report.version,
          report.renderer};
}

void print_contexts(const std::vector<context::Report>& reports) {
  std::vector<Row> rows{
      {"context", "works", "depth", "stencil", "accum", "package", "version", "renderer"}};
  for (const context::Report& report : reports) rows.push_back(row_of(report));
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
  for (const context::Report& report : reports) {
    if (!report.works) fmt::print("\n{}\n", report.why_not);
  }
}

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

// Where Mesa keeps compiled shaders (Mesa 22.3, util/disk_cache_os.c): the variable, else the
// user's cache folder, else .cache in the home folder of the password file.
fs::path shader_cache() {
  if (const char* folder = variable("MESA_SHADER_CACHE_DIR"))
    return fs::path(folder) / "mesa_shader_cache";
  if (const char* folder = variable("XDG_CACHE_HOME"))
    return fs::path(folder) / "mesa_shader_cache";
  const passwd* user = ::getpwuid(::getuid());
  return fs::path(user ? user->pw_dir : "/") / ".cache" / "mesa_shader_cache";
}

std::string state_of_cache() {
  const char* off = variable("MESA_SHADER_CACHE_DISABLE");
  if (off && (*off == '1' || *off == 't' || *off == 'T' || *off == 'y' || *off == 'Y'))
    return "off (MESA_SHADER_CACHE_DISABLE): every run compiles its shaders anew";
  const fs::path folder = shader_cache();
  fs::path there = folder;  // the folder that exists, of it and those above
  std::error_code none;
  while (!fs::exists(there, none) && there.has_relative_path()) there = there.parent_path();
  if (::access(there.c_str(), W_OK) != 0)
    return fmt::format("{} cannot be written: every run compiles its shaders anew",
                       folder.string());
  if (there != folder) return fmt::format("{}, empty: the first run compiles", folder.string());
  std::uintmax_t bytes = 0, files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
    if (!entry.is_regular_file(none)) continue;
    ++files;
    bytes += entry.file_size(none);
  }
  return fmt::format("{}, {} files, {:.1f} MB", folder.string(), files,
                     static_cast<double>(bytes) / 1e6);
}

std::string state_of_threads() {
  const char* set = variable("LP_NUM_THREADS");
  return fmt::format("{} cores; software GL draws with {}", std::thread::hardware_concurrency(),
                     set ? fmt::format("LP_NUM_THREADS={}", set)
                         : "a thread for each (LP_NUM_THREADS is not set)");
}

std::string state_of_scripts() {
  try {
    return fmt::format("{}, {} recipes", (home() / "scripts").string(), all_recipes().size());
  } catch (const MachineError& problem) {
    return problem.what();
  }
}

// What a submission would be held by, if one were graded here and now.
std::string state_of_isolation() {
  try {
    const lab::Worker worker;
    const std::string lacking = lab::names_of(worker.layers(), false);
    std::string state = lab::names_of(worker.layers());
    if (state.empty()) state = "none: grade nobody's recipes here but your own";
    if (!lacking.empty()) state += "; lacking: " + lacking;
    if (!worker.layers().namespaces)
      state += " (bubblewrap gives namespaces, where the container that this may be allows them)";
    return state;
  } catch (const MachineError& problem) {
    return problem.what();
  }
}

void doctor() {
  const auto reports = context::survey();
  fmt::print("shadowlab {}\n\n", version());
  print_contexts(reports);
  fmt::print(
      "\nDepth, stencil and accumulation bits are those of the context's own frame; recipes\n"
      "draw to one of 24 and 8 bits, and accumulate, in every context.\n\n");
  fmt::print("scripts       {}\n", state_of_scripts());
  fmt::print("shader cache  {}\n", state_of_cache());
  fmt::print("threads       {}\n", state_of_threads());
  fmt::print("isolation     {}\n", state_of_isolation());
  const auto works = [](const context::Report& report) { return report.works; };
  if (std::none_of(reports.begin(), reports.end(), works)) {
    throw MachineError(
        "no context works here, so nothing can be drawn; apt-get install libosmesa6 brings one "
        "that needs no display and no GPU");
  }
}

}  // namespace

void add_doctor(CLI::App& app, Answer& answer) {
  CLI::App* command =
      app.add_subcommand("doctor", "Show which contexts work here, and what to install");
  command->footer("Example:\n  shadowlab doctor\nEnds with 3 where no context works.");
  command->callback([&answer] {
    doctor();
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
