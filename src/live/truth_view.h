// The picture's visibility against the exact truth, while the recipe is edited.
//
// A second Recipe of the same file, under shaders that draw visibility alone, says what the
// technique thinks of each pixel; the truth is traced on another thread, so the window goes on.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>

#include "gl/screen.h"
#include "live/workshop.h"
#include "truth/comparison.h"

namespace shadowlab::live {

enum class TruthMode { off, slider, beside, error, count };
const char* name_of(TruthMode mode);

class TruthView {
 public:
  explicit TruthView(gl::Graphics& graphics)
      : graphics_(graphics), truth_(graphics), error_(graphics) {}

  /// Compares anew: what is shown is out of date until `poll` says otherwise. Draws to the main
  /// frame. Does nothing where the recipe says of no truth; then `sentence` says so.
  void begin(const std::filesystem::path& file, const recipe::Options& options,
             const recipe::Recipe& running, double time);
  /// Takes over what was traced, once it is there. Whether it was.
  bool poll();
  bool busy() const { return result_.valid(); }
  void forget();

  bool shows() const { return shows_; }
  const gl::ShownPicture& truth() const { return truth_; }  ///< grey: white where the light reaches
  /// Wrong pixels red, at an edge yellow, over a dim truth.
  const gl::ShownPicture& error() const { return error_; }
  /// "12 of 262144 pixels wrong, 0 beyond an edge, RMSE 0.0068".
  const std::string& sentence() const { return sentence_; }
  std::size_t wrong() const { return numbers_.wrong; }

 private:
  struct Pictures {
    image::Image truth, error;
    truth::Comparison numbers;
  };

  gl::Graphics& graphics_;
  gl::ShownPicture truth_, error_;
  std::future<Pictures> result_;
  truth::Comparison numbers_;
  std::string sentence_;
  bool shows_ = false;
};

}  // namespace shadowlab::live
