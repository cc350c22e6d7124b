#include "truth/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::truth {

Comparison compare(const image::FloatImage& technique, const image::FloatImage& truth,
                   const image::FloatImage& edge_mask, double tolerance) {
  for (const image::FloatImage* other : {&truth, &edge_mask}) {
    if (other->width != technique.width || other->height != technique.height ||
        other->values.size() != technique.values.size()) {
      throw InputError(
          fmt::format("Pictures of {}x{} and {}x{} cannot be compared; render both at one size.",
                      technique.width, technique.height, other->width, other->height));
    }
  }
  Comparison result{.pixels = truth.values.size()};
  double squares = 0;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    double difference = std::abs(double{technique.values[i]} - double{truth.values[i]});
    if (!(difference <= 1)) difference = 1;
    const bool edge = edge_mask.values[i] > 0;
    const bool wrong = difference > tolerance;
    result.edge_pixels += edge;
    result.wrong += wrong;
    result.wrong_beyond_edge += wrong && !edge;
    result.worst = std::max(result.worst, difference);
    squares += difference * difference;
  }
  if (result.pixels > 0) result.rmse = std::sqrt(squares / static_cast<double>(result.pixels));
  return result;
}

}  // namespace shadowlab::truth
