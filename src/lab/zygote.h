// The process that a worker is: it loads the driver once and forks for every job.
//
// It forks after GL has been used, which goes well as long as no other thread runs: so the driver
// is llvmpipe, without threads of its own and without Mesa's disk cache.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "context/context.h"
#include "lab/job.h"
#include "lab/layers.h"
#include "lab/warmth.h"

namespace shadowlab::lab {

/// The descriptor by which a worker is spoken to, from its start on.
inline constexpr int control_descriptor = 3;

/// The worker's first message is a Greeting and the renderer's name, or the sentence that says why
/// there is none.
struct Greeting {
  std::uint8_t ready;
  Layers layers;
};

/// Fork: with it go the recipe's folder as text, and the descriptors for the drawings, standard
/// output, standard error, and for the word that the child has ended. Closing the last one's other
/// end kills the child.
struct Order {
  double seconds;        ///< by the clock on the wall
  std::uint64_t memory;  ///< bytes
};

/// When a job's time is over the zygote kills it and says so; it may be busy for so long. The
/// kernel's limit of processor time lies beyond that: it ends a job without a word about why, and
/// is for those that nobody watches any more.
inline constexpr double grace_seconds = 5;

/// How a child ended.
struct Ended {
  std::int32_t status;     ///< as waitpid gives it
  std::uint8_t timed_out;  ///< by the clock on the wall
  double processor_seconds;
  std::uint64_t peak_memory;  ///< bytes
};

struct ZygoteOptions {
  int width = 256, height = 256;
  context::Backend backend = context::Backend::automatic;
  bool namespaces = false;
  std::vector<std::filesystem::path> warm = {};
  Warmth warmth = Warmth::recipes;
};

/// What a child does once it is locked in, with the channel to whoever ordered it. Tests have
/// others than drawing.
using Life = std::function<void(gl::Graphics& graphics, int channel)>;
/// Reads a job from the channel and draws it.
void draw_for(gl::Graphics& graphics, int channel);

/// Serves until the other end of control_descriptor is closed.
void serve(const ZygoteOptions& options, const Life& life = draw_for);

}  // namespace shadowlab::lab
