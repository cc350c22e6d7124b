// lua_tests: runs tests written in Lua, of what users see (src/measure/fact_file.h says how).
//
//   lua_tests FILE.lua [FACT] [--keep DIR]    runs its tests, or the one; keeps pictures as PNG
//   lua_tests FILE.lua --list                 prints their names
//
// Exit code 0: all hold; 1: one fails; 2: the file or the arguments are wrong; 3: there is no GL
// context.
#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"
#include "core/near_names.h"
#include "measure/fact_file.h"

namespace shadowlab::tests {
namespace {

struct Arguments {
  std::string file;
  std::string fact;
  std::string keep;
  bool list = false;
};

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list") {
      arguments.list = true;
    } else if (word == "--keep" && i + 1 < argc) {
      arguments.keep = argv[++i];
    } else if (word.starts_with('-') || !arguments.fact.empty()) {
      throw InputError("lua_tests FILE.lua [FACT] [--keep DIR] [--list]; what is " + word + "?");
    } else {
      (arguments.file.empty() ? arguments.file : arguments.fact) = word;
    }
  }
  if (arguments.file.empty()) throw InputError("lua_tests takes a file of tests");
  return arguments;
}

int run_all(const Arguments& arguments) {
  measure::FactFile file(arguments.file, [](std::string_view line) { fmt::print("{}", line); });
  if (!arguments.keep.empty()) {
    std::filesystem::create_directories(arguments.keep);
    file.keep_pictures_in(arguments.keep);
  }
  int ran = 0, failed = 0;
  std::vector<std::string_view> facts;
  for (const measure::Fact& test : file.facts()) {
    facts.push_back(test.name);
    if (arguments.list) fmt::print("{}\n", test.name);
    if (arguments.list || (!arguments.fact.empty() && test.name != arguments.fact)) continue;
    ++ran;
    try {
      file.run(test);
      fmt::print("holds   {}\n", test.name);
    } catch (const InputError& problem) {
      ++failed;
      fmt::print("FAILS   {}\n        {}\n", test.name, problem.what());
    }
  }
  if (!arguments.list && ran == 0) {
    throw InputError(fmt::format("{} has no test {}{}", arguments.file, arguments.fact,
                                 did_you_mean(arguments.fact, facts)));
  }
  return failed == 0 ? 0 : 1;
}

int answer(int argc, char** argv) {
  try {
    return run_all(read_arguments(argc, argv));
  } catch (const MachineError& problem) {
    fmt::print(stderr, "lua_tests: {}\n", problem.what());
    return 3;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "lua_tests: {}\n", problem.what());
    return 2;
  }
}

}  // namespace
}  // namespace shadowlab::tests

int main(int argc, char** argv) { return shadowlab::tests::answer(argc, argv); }
