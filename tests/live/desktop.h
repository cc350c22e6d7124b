// A screen of our own with a person before it: keys and a mouse that are real to the window, and
// eyes that see pixels.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "image/image.h"

namespace shadowlab::live_tests {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline bool installed(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

class Desktop : public testing::Test {
 protected:
  static constexpr int width = 1280, height = 800;

  void SetUp() override {
    if (!installed("Xvfb") || !installed("xdotool"))
      GTEST_SKIP() << "a window needs Xvfb and xdotool (packages.txt)";
    std::string name = (fs::temp_directory_path() / "shadowlab desk XXXXXX").string();
    folder = ::mkdtemp(name.data());
    start_screen();
  }

  void TearDown() override {
    end(window_);
    end(screen_);
    if (!folder.empty()) fs::remove_all(folder);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  /// Runs the program to its end, in the folder.
  int run(const std::string& arguments) const {
    return WEXITSTATUS(std::system(in_folder(SHADOWLAB_PROGRAM " " + arguments).c_str()));
  }

  /// Opens the window and waits until it is there.
  void open(const std::string& arguments) {
    window_ = start({"sh", "-c", in_folder("exec " SHADOWLAB_PROGRAM " live " + arguments)});
    ASSERT_TRUE(soon([&] { return !title().empty(); })) << text_of(folder / ".out");
  }

  std::string title() const {
    return output("xdotool search --onlyvisible --name shadowlab getwindowname");
  }
  std::string said() const { return text_of(folder / ".out"); }

  /// Keys by their names ("Down", "ctrl+1"), pressed one after the other.
  void press(const std::string& keys) const { desk("xdotool key --clearmodifiers " + keys); }
  void mouse(const std::string& what) const { desk("xdotool " + what); }

  /// The screen's only monitor: "--off", "--auto". Xvfb has no screen without any pixels, which
  /// xrandr asks for in the end and is an error of it.
  void plug(const std::string& how) const {
    (void)std::system(
        ("DISPLAY=" + display_ + " xrandr --output screen " + how + " >/dev/null 2>&1").c_str());
  }

  /// How the window ended; -1 if it did not.
  int ended() {
    int status = 0;
    const bool gone = soon([&] { return ::waitpid(window_, &status, WNOHANG) == window_; });
    if (!gone) return -1;
    window_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  bool runs() const { return window_ > 0 && ::waitpid(window_, nullptr, WNOHANG) == 0; }

  /// Looks until it is so, for as long as a slow machine may need.
  static bool soon(const std::function<bool()>& so) {
    using namespace std::chrono;
    const auto end = steady_clock::now() + seconds(60);
    while (!so()) {
      if (steady_clock::now() > end) return false;
      std::this_thread::sleep_for(milliseconds(20));
    }
    return true;
  }

  /// What is on the screen: Xvfb keeps it in a file, as xwd would write it.
  image::Image screen() const {
    const std::string file = text_of(folder / "screen" / "Xvfb_screen0");
    const auto word = [&](std::size_t i) {
      std::uint32_t value = 0;
      for (std::size_t b = 0; b < 4; ++b)
        value = value << 8 | static_cast<std::uint8_t>(file.at(4 * i + b));
      return static_cast<std::size_t>(value);
    };
    const std::size_t line = word(12), first = word(0) + 12 * word(19);
    image::Image picture(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t at =
            first + static_cast<std::size_t>(y) * line + 4 * static_cast<std::size_t>(x);
        const auto channel = [&](std::size_t c) {
          return static_cast<std::uint8_t>(file.at(at + c));
        };
        picture.set(x, y, {channel(2), channel(1), channel(0), 255});
      }
    }
    return picture;
  }

  /// Whether the picture is on the screen, pixel for pixel.
  bool shows(const image::Image& picture) const {
    const image::Image all = screen();
    const auto row = [](const image::Image& image, int x, int y) {
      return image.rgba.begin() +
             4 * (static_cast<std::ptrdiff_t>(y) * image.width + static_cast<std::ptrdiff_t>(x));
    };
    const auto bytes = 4 * static_cast<std::ptrdiff_t>(picture.width);
    for (int y = 0; y + picture.height <= all.height; ++y) {
      for (int x = 0; x + picture.width <= all.width; ++x) {
        bool same = true;
        for (int i = 0; same && i < picture.height; ++i) {
          same = std::equal(row(picture, 0, i), row(picture, 0, i) + bytes, row(all, x, y + i));
        }
        if (same) return true;
      }
    }
    return false;
  }

  fs::path folder;

 private:
  std::string in_folder(const std::string& command) const {
    return "cd '" + folder.string() + "' && DISPLAY=" + display_ + " LP_NUM_THREADS=0 " + command +
           " >>.out 2>&1 </dev/null";
  }

  void desk(const std::string& command) const {
    EXPECT_EQ(std::system(("DISPLAY=" + display_ + " " + command).c_str()), 0) << command;
  }

  std::string output(const std::string& command) const {
    const std::string file = (folder / ".answer").string();
    (void)std::system(("DISPLAY=" + display_ + " " + command + " >'" + file + "' 2>&1").c_str());
    const std::string text = text_of(file);
    return text.substr(0, text.find('\n'));
  }

  static pid_t start(const std::vector<std::string>& words, int descriptor = -1) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (descriptor >= 0) ::dup2(descriptor, 1);
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    ::execvp(pointers[0], pointers.data());
    ::_exit(127);
  }

  static void end(pid_t& process) {
    if (process <= 0) return;
    ::kill(process, SIGTERM);
    ::waitpid(process, nullptr, 0);
    process = 0;
  }

  void start_screen() {
    fs::create_directory(folder / "screen");
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    screen_ = start({"Xvfb", "-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp",
                     "-noreset", "-fbdir", (folder / "screen").string()},
                    pipe[1]);
    ::close(pipe[1]);
    char number[16] = {};
    ASSERT_GT(::read(pipe[0], number, sizeof number - 1), 0) << "Xvfb does not start";
    ::close(pipe[0]);
    display_ = ":" + std::to_string(std::atoi(number));
  }

  pid_t screen_ = 0, window_ = 0;
  std::string display_;
};

}  // namespace shadowlab::live_tests
