// Random numbers that are the same on every machine: std::uniform_real_distribution may differ
// between libraries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>

namespace shadowlab::measure {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// 0 to count - 1.
  int below(int count) { return static_cast<int>(unit() * count); }
  bool chance(double share) { return unit() < share; }
  /// Uniform on the unit sphere.
  glm::dvec3 direction() {
    const double height = between(-1, 1), angle = between(0, 2 * 3.141592653589793);
    const double radius = std::sqrt(std::max(0.0, 1 - height * height));
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace shadowlab::measure
