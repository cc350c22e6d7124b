// Files from texts, and one context for the whole program.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "lab/job.h"

namespace shadowlab::lab {

inline constexpr int frame_size = 32;

/// A folder of its own, with what is written into it, for as long as this lives.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("shadowlab-lab-{}-{}", ::getpid(), next_++)) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, std::string_view text) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  static inline int next_ = 0;
  std::filesystem::path path_;
};

/// One file, in a folder of its own.
class TextFile {
 public:
  explicit TextFile(std::string_view text, const std::string& name = "recipe.lua")
      : path_(folder_.write(name, text)) {}
  const std::filesystem::path& path() const { return path_; }

 private:
  Folder folder_;
  std::filesystem::path path_;
};

/// A recipe whose draw is `body`.
inline std::string recipe_text(std::string_view body, std::string_view fields = "") {
  return fmt::format("local recipe = {{ {} }}\nfunction recipe.draw(r) {} end\nreturn recipe\n",
                     fields, body);
}

class LabTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graphics_ = std::make_unique<gl::Graphics>(context::create(), frame_size, frame_size);
  }
  static void TearDownTestSuite() { graphics_.reset(); }
  static gl::Graphics& graphics() { return *graphics_; }

  static std::vector<Drawing> draw_all(const Job& job) {
    std::vector<Drawing> drawings;
    draw(*graphics_, job, [&](std::size_t shot, Drawing drawing) {
      EXPECT_EQ(shot, drawings.size());
      drawings.push_back(std::move(drawing));
    });
    return drawings;
  }
  static Job one_shot(const std::filesystem::path& recipe) {
    Job job;
    job.recipe = recipe;
    job.width = job.height = frame_size;
    job.shots.emplace_back();
    return job;
  }
  /// Its one shot, with its passes.
  static Drawing draw_one(const std::filesystem::path& recipe) {
    Job job = one_shot(recipe);
    job.passes = everything;
    job.calls = true;
    return draw_all(job).at(0);
  }

 private:
  static inline std::unique_ptr<gl::Graphics> graphics_;
};

}  // namespace shadowlab::lab
