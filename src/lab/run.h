// A grading run: many submissions, several at once, into a folder that can be taken up again.
//
//   OUT/run.json                       what the run is of: lab, seed, shard; a run is taken up only
//                                      by one that agrees
//   OUT/submissions/NAME/result.json   written last, whole: a submission is graded when it is there
//   OUT/submissions/NAME/report.html, *.png
//   OUT/expected/*.png                 the reference's
//   OUT/index.html, scores.csv         of all, at the end
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/grade.h"

namespace shadowlab::lab {

/// Submission k of a run belongs to shard k mod count.
struct Shard {
  int index = 0;  ///< from 0
  int count = 1;
};

/// "3/8", the third of eight. Throws InputError.
Shard shard_from(const std::string& text);
/// What the machines that start many of us say: Slurm's array, GoogleTest's shards, Kubernetes'
/// indexed jobs. Nothing where none speaks. Throws InputError for what makes no sense.
std::optional<Shard> shard_from_environment();

/// What two runs must agree on to be one.
struct RunIdentity {
  std::string lab, title;
  std::uint64_t digest = 0, seed = 0;
  Shard shard;
  Language language = Language::english;
  Hidden hidden = Hidden::left_out;
  std::string driver;
};

struct RunOptions {
  std::filesystem::path out;
  int jobs = 1;  ///< how many are drawn at once
  GradeOptions grade;
  Shard shard;
  /// Told of each result, also of those that were there already; never two at once.
  std::function<void(const Result&, std::size_t done, std::size_t all)> progress;
};

/// Grades those of the submissions that are this shard's and have no result yet, and gives the
/// results of all of the shard, by name. Throws InputError where the folder holds another run, or
/// another process is at work in it.
std::vector<Result> run(const Lab& lab, const Reference& reference,
                        std::span<const Submission> submissions, const DrawSubmission& draw,
                        const RunOptions& options);

/// The results in a run's folder, by name; none where its shard is empty. Throws InputError where
/// it is no run's.
std::vector<Result> results_in(const std::filesystem::path& out);
RunIdentity identity_of(const std::filesystem::path& out);
void write_identity(const std::filesystem::path& out, const RunIdentity& identity);

/// Puts the shards' folders together into `out`. Throws InputError where they are of different runs
/// or both have a result of one submission that differs.
std::vector<Result> merge(std::span<const std::filesystem::path> folders,
                          const std::filesystem::path& out);

}  // namespace shadowlab::lab
