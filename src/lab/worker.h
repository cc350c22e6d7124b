// Submissions, drawn where they can do no harm. All that a grader needs is one line a submission:
//
//   lab::Worker worker;                                  // once, for any number of threads
//   const lab::Outcome outcome = worker.draw(job);       // for each submission
//
//   worker.draw(job, [](std::size_t shot, lab::Drawing drawing) { … });   // each as soon as it is
//
// A worker is a process of its own (`shadowlab worker`), in namespaces of its own where bubblewrap
// gives them. It loads the driver, draws the recipes of Isolation::warm, so that the common shaders
// are compiled, and forks for every job. The child gives up all that drawing does not need
// (lock.h), then reads the job, and sends its drawings over a socket that the script has no name
// for. It sees its own recipe, scripts/ and shaders/, and no other file; it has a budget of time
// and memory; when it ends, or is ended, nothing of it is left. The next child begins as it did: a
// compiled shader or a broken state never goes from one submission to another.
//
// A reference drawn by a worker too, as a job of its own, comes from the same driver and never
// shares a process with a submission.
//
// What it does not do: judge a picture, or trust one. Whoever owns the child may send any pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "context/context.h"
#include "lab/job.h"
#include "lab/layers.h"
#include "lab/warmth.h"

namespace shadowlab::lab {

struct Isolation {
  double seconds = 30;                        ///< of one job, by the clock on the wall
  std::size_t memory = std::size_t{1} << 30;  ///< bytes that a job may need beyond the driver's own
  std::size_t words = std::size_t{64} << 10;  ///< bytes on standard output, and as many on error
  std::size_t results = std::size_t{256} << 20;  ///< bytes of all drawings of a job
  /// Drawn once before any submission, in a picture of this size: for speed alone. Nothing that a
  /// submission may not know: a submission that owned its process could read the memory.
  std::vector<std::filesystem::path> warm = {};
  Warmth warmth = Warmth::recipes;
  int width = 256, height = 256;  ///< pixels
  context::Backend backend = context::Backend::automatic;
  enum class Namespaces { where_allowed, none } namespaces = Namespaces::where_allowed;
  std::filesystem::path program =
      {};  ///< whose `worker` command it is; this program's unless given
};

enum class Verdict {
  finished,      ///< every shot was drawn
  recipe_error,  ///< the recipe is wrong: Outcome::sentence says how
  timed_out,
  out_of_memory,
  crashed,
  forbidden,  ///< a call to the system that drawing does not need
  flooded,    ///< more words or drawings than anybody reads
  garbled,    ///< bytes that are no drawings
};
/// "finished", "recipe error", "timed out" …
std::string_view name_of(Verdict verdict);

struct Outcome {
  Verdict verdict = Verdict::finished;
  std::string sentence;           ///< what happened and what to do; empty for `finished`
  std::vector<Drawing> drawings;  ///< of the first shots, as many as came; empty where handed over
  std::string out, err;           ///< standard output and error, not what the recipe prints
  double seconds = 0;             ///< by the clock on the wall
  double processor_seconds = 0;
  std::size_t peak_memory = 0;  ///< bytes resident, the driver's own included
  Layers layers;                ///< that held
};

class Worker {
 public:
  /// Starts it. Throws MachineError where it cannot be.
  explicit Worker(Isolation isolation = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Draws the job's shots, in a process of their own; from any thread, any number at once. What is
  /// wrong with the submission is in the outcome, never thrown. Throws MachineError where the
  /// worker is gone and cannot be started anew.
  Outcome draw(const Job& job);
  /// Hands each drawing over as soon as it is there, in the order of the shots.
  Outcome draw(const Job& job, const std::function<void(std::size_t shot, Drawing)>& each);

  Layers layers() const;
  std::string renderer() const;  ///< GL_RENDERER of the worker's context

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A worker for one job alone.
Outcome draw_isolated(const Job& job, const Isolation& isolation = {});

}  // namespace shadowlab::lab
