// Times as they are shown: means over a quarter of a second, since nobody reads sixty a second.
#pragma once

#include <span>
#include <vector>

#include "live/inspector.h"

namespace shadowlab::live {

class Readings {
 public:
  /// What was measured of the frame that the window shows now, `seconds` after the last.
  void add(double frame_ms, std::span<const PassReport> passes, double seconds);

  double frame_ms() const { return shown_.frame; }
  /// Milliseconds of the passes that were added last, in their order.
  const std::vector<double>& passes_ms() const { return shown_.passes; }

 private:
  struct Times {
    double frame = 0;
    std::vector<double> passes;
  };
  std::vector<PassName> names_;
  Times sum_, shown_;
  int frames_ = 0;
  double age_ = 0;  ///< seconds since `shown_` was new
};

}  // namespace shadowlab::live
