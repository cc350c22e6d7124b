// What the tests of the sandbox share: a folder, a worker's limits, and an honest submission.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.h"
#include "lab/worker.h"

namespace shadowlab::sandbox_tests {

// A sanitizer makes everything slower, and crashes in its own words.
#ifdef __SANITIZE_ADDRESS__
inline constexpr double slowness = 4;
#else
inline constexpr double slowness = 1;
#endif

/// Seconds that nothing takes which ends by itself, wherever the tests run: 2 on a quiet machine.
inline constexpr double ample = 100;

/// The limits of a worker for honest submissions.
inline lab::Isolation isolation() {
  return {.seconds = 20 * slowness, .width = 16, .height = 8, .program = SHADOWLAB_PROGRAM};
}

class InFolder : public testing::Test {
 protected:
  InFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "sandbox test XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~InFolder() override {
    std::error_code none;
    std::filesystem::remove_all(folder, none);
  }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }

  /// Two pictures without a shader: the left half red and stencil 1 there, the rest blue; then the
  /// same in green.
  lab::Job honest() const {
    lab::Job job{.recipe = write("honest.lua", R"(
local recipe = { params = { color = param.point(1, 0, 0) } }
function recipe.draw(r)
  local c = r.params.color
  gl.ClearColor(0, 0, 1, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT)
  pass("left", function()
    gl.Enable(gl.SCISSOR_TEST)
    gl.Scissor(0, 0, r.width // 2, r.height)
    gl.ClearColor(c.x, c.y, c.z, 1)
    gl.ClearStencil(1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  end)
end
return recipe)"),
                 .width = 16,
                 .height = 8};
    job.shots.emplace_back();
    job.shots.push_back({.settings = {{"color", "0,1,0"}}});
    return job;
  }

  static void expect_honest(const lab::Outcome& outcome) {
    EXPECT_EQ(outcome.verdict, lab::Verdict::finished) << outcome.sentence;
    ASSERT_EQ(outcome.drawings.size(), 2u);
    const std::array<std::uint8_t, 4> red{255, 0, 0, 255}, green{0, 255, 0, 255},
        blue{0, 0, 255, 255};
    for (std::size_t i = 0; i < 2; ++i) {
      const lab::Buffers& frame = outcome.drawings[i].frame;
      for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
          EXPECT_EQ(frame.color.at(x, y), x >= 8 ? blue : i == 0 ? red : green);
          EXPECT_EQ(frame.stencil[static_cast<std::size_t>(16 * y + x)], x < 8 ? 1 : 0);
        }
      }
    }
  }

  std::filesystem::path folder;
};

}  // namespace shadowlab::sandbox_tests
