// What is found out of one job, and how: once of its picture, in rounds of its time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/errors.h"
#include "measure/fill.h"
#include "measure/ground_truth.h"
#include "measure/job.h"

namespace shadowlab::measure {

/// What does not depend on the clock, but for first_frame.
struct Look {
  /// Why there is nothing else: the recipe fails here, or does not claim to hold.
  std::optional<std::string> left_out;
  std::string title;
  bool soft = false;
  bool on_receivers = false;
  Errors errors;
  double flip_mean = 0, flip_worst = 0;  ///< LDR-FLIP of the final picture against the reference's
  std::uint64_t triangles = 0, draws = 0, upload_bytes = 0;
  std::uint64_t gl_bytes = 0;    ///< what GL holds for the recipe, by its formats
  std::uint64_t peak_bytes = 0;  ///< the most memory the process had; 0 where nobody tells
  std::vector<PassFill> passes;  ///< of one name each; no times
  double first_frame = 0;        ///< ms, with shaders compiled and each draw made twice
};

/// The pictures behind a look.
struct LookPictures {
  image::Image visibility, error;
};

/// Draws the job in the frame of `graphics`, which it leaves to the next.
Look look_at(gl::Graphics& graphics, const Job& job, GroundTruth& truth, double radius,
             LookPictures& pictures);

/// One round of frames, after one that is not counted.
struct Round {
  std::vector<double> frames;  ///< ms each, between two glFinish
  /// ms of each pass of Look::passes, in frames of their own that have glFinish around each pass.
  std::vector<std::vector<double>> passes;
};

/// As many frames as fit into `milliseconds`, at least one and at most `most`; a third as many for
/// the passes.
Round time(gl::Graphics& graphics, const Job& job, double radius, double milliseconds, int most);

}  // namespace shadowlab::measure
