// Runs the program as a user does, and keeps what it said.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace shadowlab::cli_tests {

namespace fs = std::filesystem;

struct Ended {
  int code;  ///< the exit code; 128 and more: ended by a signal, as a shell counts
  std::string out, err;
};

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Each test has a folder of its own, in which the program runs; its name has a space.
class Cli : public testing::Test {
 protected:
  Cli() {
    std::string name = (fs::temp_directory_path() / "shadowlab cli XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~Cli() override {
    std::error_code none;
    fs::permissions(folder, fs::perms::owner_all, none);
    fs::remove_all(folder, none);
  }

  /// `arguments` as a shell reads them; `before` is put before the program: variables, a pipe.
  Ended run(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd '" + folder.string() + "' && { " + before + " '" +
                                SHADOWLAB_PROGRAM + "' " + arguments +
                                "; } >.out 2>.err </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            text_of(folder / ".out"), text_of(folder / ".err")};
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  /// A recipe whose draw is `body`.
  void write_recipe(const std::string& name, const std::string& body) const {
    write(name, "local r = {}\nfunction r.draw(r)\n" + body + "\nend\nreturn r\n");
  }

  bool has(const std::string& name) const { return fs::exists(folder / name); }

  fs::path folder;
};

/// One sentence on standard error, none of C++'s words in it, and this exit code.
inline void expect_sentence(const Ended& ended, int code, const std::string& part) {
  EXPECT_EQ(ended.code, code) << ended.err;
  EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << "more than one line: " << ended.err;
  EXPECT_TRUE(ended.err.starts_with("shadowlab: ")) << ended.err;
  for (const char* word : {"std::", "terminate", "what():", "exception", "basic_string", "nullptr"})
    EXPECT_EQ(ended.err.find(word), std::string::npos) << ended.err;
}

}  // namespace shadowlab::cli_tests
