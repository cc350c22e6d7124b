// The median: what a noisy machine's times are summed up by.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace shadowlab::measure {

/// The middle of `values`, of an even number the upper one of the two; there is at least one.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace shadowlab::measure
