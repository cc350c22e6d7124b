// The command line: one file a command, and how each ends.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/commands.h"
#include "core/error.h"
#include "core/version.h"

namespace {

int fail(int code, std::string sentence) {
  if (!sentence.ends_with('.') && !sentence.ends_with('?') && !sentence.ends_with('!'))
    sentence += '.';
  std::fflush(stdout);
  fmt::print(stderr, "shadowlab: {}\n", sentence);
  return code;
}

// Parses and runs; what goes wrong is an exception.
int run(CLI::App& app, int argc, char** argv) {
  using namespace shadowlab;
  cli::Answer answer = cli::Answer::yes;
  for (const auto add :
       {cli::add_run, cli::add_live, cli::add_trace, cli::add_list, cli::add_new, cli::add_gallery,
        cli::add_diff, cli::add_check, cli::add_measure, cli::add_stress, cli::add_grade,
        cli::add_merge, cli::add_pack, cli::add_doctor, cli::add_worker})
    add(app, answer);
  app.parse(argc, argv);
  if (app.get_subcommands().empty()) {
    fmt::print(stderr, "{}", app.help());
    return 2;
  }
  if (std::fflush(stdout) != 0) return fail(2, "cannot write to standard output");
  return static_cast<int>(answer);
}

// The system takes memory, threads and GL back faster than their owners give them: a tenth of a
// short run. The sanitizers look at what is left, so there it goes the long way.
int end(int code) {
#ifndef __SANITIZE_ADDRESS__
  if (std::fflush(stdout) == 0 && std::fflush(stderr) == 0) std::_Exit(code);
#endif
  return code;
}

int parse_and_run(CLI::App& app, int argc, char** argv) {
  using namespace shadowlab;
  try {
    return run(app, argc, argv);
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) return app.exit(problem);  // --help, --version
    return fail(2, cli::sentence_of(problem, app));
  } catch (const InputError& problem) {
    return fail(2, problem.what());
  } catch (const MachineError& problem) {
    return fail(3, problem.what());
  } catch (const std::bad_alloc&) {
    return fail(3, "this machine has no memory left for that");
  } catch (const std::filesystem::filesystem_error& problem) {
    return fail(2, problem.path1().string() + ": " + problem.code().message());
  } catch (const std::exception& problem) {
    return fail(2, problem.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace shadowlab;
  // `shadowlab trace X | head` ends without a word, also where whoever started us ignores SIGPIPE.
  std::signal(SIGPIPE, SIG_DFL);
  CLI::App app("shadowlab: shadow algorithms as short Lua scripts", "shadowlab");
  app.set_version_flag("--version", "shadowlab " + std::string(version()));
  app.require_subcommand(0, 1);
  app.footer(
      "Example:\n  shadowlab run projected_stencil -o out.png\n"
      "Each command has its own: shadowlab run --help\n"
      "Ends with 0: done; 1: done, and the answer is no; 2: wrong usage or input; 3: this machine "
      "cannot.");
  return end(parse_and_run(app, argc, argv));
}
