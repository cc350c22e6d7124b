// Speed against error: recipes over their sweeps and over scenes, in one run.
//
// First each job's picture is held against the truth; then all are timed in rounds, A B C A B C, so
// that a machine that drifts favours none. Everything is kept in the folder as it is found, and a
// run that was interrupted takes up there.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gl/graphics.h"
#include "measure/curves.h"
#include "measure/job.h"
#include "measure/record.h"

namespace shadowlab::measure {

struct SweepOptions {
  std::vector<std::filesystem::path> recipes;
  std::vector<std::string> scenes;
  std::filesystem::path reference;  ///< the recipe whose picture is the truth's (GroundTruth)
  Extent extent = Extent::full;
  double radius = 0.2;     ///< of the light of all soft recipes, metres
  double bar = 1.0 / 512;  ///< the standard error of soft truths
  int rounds = 3;
  double milliseconds = 120;  ///< of frames, a job and round
  int most_frames = 12;       ///< likewise
  double slow = 1500;         ///< ms of a first frame, from which on a job is timed once
  int bar_check_size = 128;   ///< of the pictures that check_bar traces, pixels
  CurveOptions curves;
};

/// What is being done, for a line of progress.
struct Progress {
  std::size_t done = 0, all = 1;  ///< steps
  std::string what;
};

/// Measures in `graphics`, keeping journal.jsonl and pictures/ in `folder`, which exists. Gives the
/// whole report (measure.schema.json). Throws InputError for what is wrong with the options.
Json sweep(gl::Graphics& graphics, const SweepOptions& options, const std::filesystem::path& folder,
           const std::function<void(const Progress&)>& progress);

/// The names of the pictures of a point, relative to the folder.
struct PictureNames {
  std::string visibility, error;
};
PictureNames pictures_of(const std::string& point);
/// That of a scene's truth.
std::string truth_picture_of(const std::string& scene, bool soft);

}  // namespace shadowlab::measure
