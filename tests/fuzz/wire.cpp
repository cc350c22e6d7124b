// Any bytes are a drawing of what was asked for, or Garbled; and what is one can be sent again.
#include "lab/wire.h"

#include <cstdlib>
#include <cstring>

namespace {

using namespace shadowlab::lab;

Job a_job() {
  Job job{.recipe = "a.lua", .width = 2, .height = 2, .passes = everything, .calls = true};
  job.shots.resize(2);
  return job;
}

void take_drawing(std::span<const std::uint8_t> body) {
  const wire::ShotDrawing drawn = wire::drawing_from(body, a_job());
  const Drawing& drawing = drawn.drawing;
  if (drawn.shot > 1 || drawing.passes.size() > most_passes || drawing.calls.size() > most_calls)
    std::abort();
  const wire::Bytes again = wire::message_of(drawn.shot, drawing);
  const auto twice = wire::drawing_from(std::span(again).subspan(wire::header_size), a_job());
  if (wire::message_of(twice.shot, twice.drawing) != again) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < wire::header_size) return 0;
  try {
    const std::span<const std::uint8_t> all(bytes, size);
    const wire::Header header = wire::header_from(all.first<wire::header_size>());
    const auto body = all.subspan(wire::header_size);
    if (header.kind == wire::Kind::job) {
      (void)wire::job_from(body);
    } else if (header.kind == wire::Kind::drawing) {
      take_drawing(body);
    }
  } catch (const wire::Garbled&) {
  }
  return 0;
}
