// The state of GL under which a frame's pictures are made, from the trace alone: for a diagnosis,
// never for a mark.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/job.h"

namespace shadowlab::lab {

/// One thing that is set: "glEnable(GL_STENCIL_TEST)", "glStencilFunc", "uniform lit".
struct Setting {
  std::vector<std::string> values;  ///< "on"; "GL_EQUAL", "1", "0xFF"
  bool operator==(const Setting&) const = default;
};
using GlState = std::map<std::string, Setting>;

/// A call that changes a buffer: a draw, a clear, a blit, an accumulation.
struct Work {
  std::size_t call = 0;  ///< its index in the trace
  int pass = -1;
  GlState state;  ///< what was set before it
};

/// The works of a trace, in their order; at most 2000.
std::vector<Work> works_of(std::span<const Call> calls);

/// The first thing under which two passes work differently.
struct StateDifference {
  std::string key;
  std::optional<Setting> yours, theirs;  ///< nothing: never set, GL's default
};

/// Compares the works of pass `yours` of one trace with those of pass `theirs` of the other, in
/// their order; state switches first, since uniforms often differ in consequence alone. Empty where
/// they agree.
std::vector<StateDifference> differences(std::span<const Work> your_works, int yours,
                                         std::span<const Work> their_works, int theirs);

/// What replaces one state by the reference's in one pass: put before each draw of pass `yours`,
/// and taken back where the submission sets it anew. Empty where no call of numbers and
/// names can say it.
std::vector<Change> changes_to(const StateDifference& difference, std::span<const Work> your_works,
                               int yours, std::span<const Work> their_works, int theirs);

/// "GL_EQUAL", "1", "0xFF" as students write it: "EQUAL 1 0xFF".
std::string in_words(const Setting& setting);

/// The same for traces that differ in names of GL objects alone: for near-duplicates.
std::uint64_t digest_of(std::span<const Call> calls, std::uint64_t before);

}  // namespace shadowlab::lab
