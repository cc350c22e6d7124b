#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "core/clock.h"

namespace shadowlab::cli {

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(std::size_t done, std::size_t all, const std::string& what) {
  if (!terminal_) return;
  const double now = now_ms();
  if (!shown_) {
    began_ = now;
    first_ = done;
  }
  clear();
  shown_ = true;
  std::string left;
  const std::size_t steps = done - first_;
  if (steps >= 5 && done < all) {
    const double each = (now - began_) / 1000 / static_cast<double>(steps);
    left = "; " + time_left(each * static_cast<double>(all - done));
  }
  fmt::print(stderr, "{} of {}: {}{}", done + 1, all, what, left);
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (terminal_ && shown_) fmt::print(stderr, "\r\x1b[K");
}

std::string time_left(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "";
  if (seconds < 90) return fmt::format("{:.0f} s left", std::ceil(seconds));
  return fmt::format("{:.0f} min left", std::ceil(seconds / 60));
}

}  // namespace shadowlab::cli
