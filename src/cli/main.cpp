// The command line: one file a command, and how each ends.
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "cli/commands.h"
#include "core/error.h"
#include "core/version.h"

namespace {

int fail(int code, const std::string& sentence) {
  std::fflush(stdout);
  fmt::print(stderr, "shadowlab: {}\n", sentence);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace shadowlab;
  CLI::App app("shadowlab: shadow algorithms as short Lua scripts");
  app.set_version_flag("--version", std::string(version()));
  app.require_subcommand(1);
  cli::Answer answer = cli::Answer::yes;
  cli::add_run(app, answer);
  try {
    app.parse(argc, argv);
    if (std::fflush(stdout) != 0) return fail(2, "cannot write to standard output.");
    return static_cast<int>(answer);
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) return app.exit(problem);  // --help, --version
    return fail(2, std::string(problem.what()) + " (see shadowlab --help)");
  } catch (const InputError& problem) {
    return fail(2, problem.what());
  } catch (const MachineError& problem) {
    return fail(3, problem.what());
  } catch (const std::bad_alloc&) {
    return fail(3, "this machine has no memory left for that.");
  } catch (const std::exception& problem) {
    return fail(2, problem.what());
  }
}
