// The clock that all times are taken by.
#pragma once

#include <chrono>

namespace shadowlab {

/// Milliseconds since some fixed moment.
inline double now_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace shadowlab
