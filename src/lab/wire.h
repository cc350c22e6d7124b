// Jobs and drawings as bytes: what passes between the grader and the process that draws a
// submission.
//
// A message is a header (what it is, how long) and so many bytes. Whoever owns the drawing process
// may send anything: every count is held against what is left before anything is made of it, every
// picture against the size that the job asked for, and no byte may be left over.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "lab/job.h"

namespace shadowlab::lab::wire {

using Bytes = std::vector<std::uint8_t>;

/// The bytes are no message of ours: one sentence.
class Garbled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Kind : std::uint32_t { job = 1, drawing = 2, done = 3 };

struct Header {
  Kind kind;
  std::uint64_t length;  ///< of what follows
};
inline constexpr std::size_t header_size = 16;

/// Throws Garbled for a foreign version or an unknown kind.
Header header_from(std::span<const std::uint8_t, header_size> bytes);

/// Whole messages, headers included.
Bytes message_of(const Job& job);
Bytes message_of(std::size_t shot, const Drawing& drawing);
Bytes done_message();

/// What follows the header. Throws Garbled.
Job job_from(std::span<const std::uint8_t> bytes);

struct ShotDrawing {
  std::size_t shot;
  Drawing drawing;
};
/// The drawing of a shot of `job`: its pictures have the job's size or none, its depths are window
/// depths, and its texts have no control characters but line ends. Throws Garbled.
ShotDrawing drawing_from(std::span<const std::uint8_t> bytes, const Job& job);

}  // namespace shadowlab::lab::wire
