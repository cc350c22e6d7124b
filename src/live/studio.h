// Everything of a live session but its window: the recipes on their benches, one camera, one
// light, one clock, and what the user is looking at.
//
//   Studio studio(graphics, {{"scripts/room.lua"}, {}, {}});
//   studio.step(1.0 / 60);          // looks at the files, draws what has to be drawn
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/screen.h"
#include "live/clock.h"
#include "live/orbit.h"
#include "live/workshop.h"

namespace shadowlab::live {

/// One recipe and the last picture of it.
struct Bench {
  Bench(gl::Graphics& graphics, const std::filesystem::path& file, const recipe::Options& options)
      : workshop(graphics, file, options), picture(graphics) {}
  Workshop workshop;
  gl::ShownPicture picture;
  double frame_ms = 0;  ///< of the last frame, until GL had finished it
};

struct StudioOptions {
  std::vector<std::filesystem::path> recipes;
  std::vector<std::pair<std::string, std::string>> settings;  ///< parameters, of all recipes
  recipe::Options recipe;
};

class Studio {
 public:
  /// Throws InputError where no recipe has a parameter that is set.
  Studio(gl::Graphics& graphics, StudioOptions options);

  gl::Graphics& graphics() { return graphics_; }
  std::vector<std::unique_ptr<Bench>>& benches() { return benches_; }
  /// The one that keys and panels are about.
  Bench& bench() { return *benches_[focus_]; }
  std::size_t focus() const { return focus_; }
  void set_focus(std::size_t index) { focus_ = index < benches_.size() ? index : 0; }
  Clock& clock() { return clock_; }

  /// Lets so much time pass, looks at the files and draws. Whether there is anything new to see.
  bool step(double seconds);
  /// Draws again at the next step, whatever the clock says.
  void touch() { touched_ = true; }
  void reload_all();

  /// The camera of all benches: the scene's until it is moved. Nothing before there is a scene.
  std::optional<scene::Camera> camera() const;
  void set_camera(const scene::Camera& camera);
  void reset_camera();

  /// Sets a parameter of the bench in focus; the light of all. Throws InputError.
  void set(const std::string& name, const std::string& value);
  /// What the bench's recipe does on this character; whether it does anything.
  bool press(std::string_view character);

 private:
  gl::Graphics& graphics_;
  std::vector<std::unique_ptr<Bench>> benches_;
  std::size_t focus_ = 0;
  Clock clock_;
  std::optional<scene::Camera> camera_;
  bool touched_ = true;
};

}  // namespace shadowlab::live
