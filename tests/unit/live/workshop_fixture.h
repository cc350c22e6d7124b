// A folder with a recipe that is edited, and a small context to draw it in.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "live/workshop.h"

namespace shadowlab::live {

namespace fs = std::filesystem;

class WorkshopTest : public testing::Test {
 protected:
  WorkshopTest() : graphics(context::create(context::Backend::osmesa), 16, 16) {
    std::string name = (fs::temp_directory_path() / "shadowlab live XXXXXX").string();
    folder = ::mkdtemp(name.data());
    options.limits.instructions = 300'000;
  }
  ~WorkshopTest() override { fs::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  /// The same by way of another file, as many editors do.
  void write_by_rename(const std::string& name, const std::string& text) const {
    write(name + "~", text);
    fs::rename(folder / (name + "~"), folder / name);
  }

  /// A version that fills the picture: red as given, green as its parameter "level" says.
  static std::string filling(int red) {
    return "local recipe = { params = { level = param.number(0.2, 0, 1) } }\n"
           "function recipe.draw(r)\n"
           "  pass(\"fill\", function()\n"
           "    gl.ClearColor(" +
           std::to_string(red) +
           " / 255, r.params.level, 0, 1)\n"
           "    gl.Clear(gl.COLOR_BUFFER_BIT)\n"
           "  end)\n"
           "end\n"
           "return recipe\n";
  }

  std::array<std::uint8_t, 4> pixel() { return graphics.frame.read_color().at(3, 3); }

  /// Looks and draws until a version was tried; how many looks that took.
  int looks_until_tried(Workshop& workshop) {
    for (int looks = 1; looks <= 10; ++looks) {
      if (!workshop.look()) continue;
      workshop.draw({});
      return looks;
    }
    return 0;
  }

  gl::Graphics graphics;
  fs::path folder;
  recipe::Options options;
};

}  // namespace shadowlab::live
