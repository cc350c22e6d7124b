// What is said of a version that does not run.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::live {

struct SourceLine {
  int number;
  std::string text;
};

struct Failure {
  enum class Stage { loading, setup, frame };
  Stage stage = Stage::loading;
  std::string sentence;  ///< what is wrong, without file, line and pass
  std::string file;      ///< as the error names it; empty where it names none
  int line = 0;          ///< 0 where it names none
  std::string pass;
  std::vector<SourceLine> around;  ///< the lines around `line`, as they are in the file now
};

/// "loading", "setup", "drawing".
std::string_view name_of(Failure::Stage stage);

/// Takes an error's sentence apart: `FILE:LINE: in pass "NAME": what is wrong`. Any text will do.
Failure failure_of(std::string_view error, Failure::Stage stage);

}  // namespace shadowlab::live
