// What is in the main frame's buffers after each pass, as files.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/session.h"
#include "image/image.h"

namespace shadowlab::cli {

/// The pictures of one pass.
struct Capture {
  std::string pass;
  std::string stem;  ///< "01_the_receiver_marks_the_stencil"
  image::Image color;
};

/// From its making on, every pass of the session's recipe is captured: STEM.color.png,
/// STEM.depth.png (nearest black, farthest white, over the depths present), STEM.stencil.png (one
/// colour a value, with a legend), and STEM.depth.npy, STEM.stencil.npy, STEM.color.npy with the
/// raw values.
class Captures {
 public:
  /// Makes the folder. Throws InputError where it cannot.
  Captures(std::filesystem::path folder, Session& session);
  ~Captures();
  Captures(const Captures&) = delete;
  Captures& operator=(const Captures&) = delete;

  /// Writes index.json: pass names and file names. Throws InputError where a file could not be
  /// written.
  void finish();
  const std::vector<Capture>& passes() const { return passes_; }

 private:
  void capture(std::size_t pass);

  std::filesystem::path folder_;
  Session& session_;
  std::vector<Capture> passes_;
};

/// What the files of a pass are called, counting from 0: "01_the_receiver_marks_the_stencil".
std::string stem_of(std::size_t index, std::string_view pass);

/// Stencil values as a picture, with a legend of the values present below it.
image::Image stencil_picture(const std::vector<std::uint8_t>& stencil, int width, int height);

}  // namespace shadowlab::cli
