// What the grader takes from the process that draws a submission: internal to this floor.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lab/channel.h"
#include "lab/wire.h"
#include "lab/worker.h"
#include "lab/zygote.h"

namespace shadowlab::lab {

/// Our ends of a job's lines to its process and, the last, to the zygote.
struct Lines {
  Descriptor channel, out, err, word;
};

/// What came of one job. Everything is bounded, and nothing that comes is believed.
class Reception {
 public:
  using Each = std::function<void(std::size_t shot, Drawing)>;
  Reception(const Job& job, const Isolation& isolation, const Each& each)
      : job_(job), isolation_(isolation), each_(each) {}

  /// Sends the order and receives, until the process has ended, or has to be: closing the lines
  /// ends it. What a lost one has handed over is not handed over again by the next.
  void receive(Lines& lines, std::span<const std::uint8_t> order);

  std::string out, err;        ///< standard output and error
  std::optional<Ended> ended;  ///< how, if it ended of itself or by the zygote
  bool lost = false;           ///< the zygote ended before it could say
  bool unanswered = false;     ///< the zygote did not say in time
  bool flooded = false;
  bool done = false;                       ///< it says that it has drawn all
  std::optional<std::string> garbled;      ///< why what came is no drawing
  std::size_t shots = 0;                   ///< drawn so far
  std::size_t handed_over = 0;             ///< of them, over all that were lost
  std::optional<std::string> first_error;  ///< of the drawings

 private:
  void read_channel(Descriptor& channel);
  void read_words(Descriptor& from, std::string& words);
  void read_end(Descriptor& word);
  void take_messages();
  void take(wire::Header header, std::span<const std::uint8_t> body);

  const Job& job_;
  const Isolation& isolation_;
  const Each& each_;
  wire::Bytes unread_;
  std::size_t received_ = 0;
};

}  // namespace shadowlab::lab
