// The sizes and counts that every mesh maker accepts; outside them a request is a mistake.
#pragma once

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::scene {

inline constexpr std::size_t max_triangles = 4'000'000;

/// Throws InputError unless `value` is a length in metres that floats can carry with room to spare.
inline void check_length(std::string_view name, double value) {
  if (!(value >= 1e-9 && value <= 1e9)) {
    throw InputError(fmt::format("The {} is {}; it must be between 1e-9 and 1e9.", name, value));
  }
}

/// Throws InputError unless `low` ≤ `value` ≤ `high`.
inline void check_count(std::string_view name, int value, int low, int high) {
  if (value < low || value > high) {
    throw InputError(
        fmt::format("The {} is {}; it must be between {} and {}.", name, value, low, high));
  }
}

}  // namespace shadowlab::scene
