// How far a technique's visibility is from the truth's, and where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"

namespace shadowlab::measure {

/// The truth of one view: what a technique's picture is compared with.
struct Truth {
  image::FloatImage visibility;
  image::FloatImage edges;  ///< 1 where a rasteriser may rightly differ (Tracer::edge_mask)
  /// How far the visibility of a pixel may be off: one standard error. 0 where it is exact.
  double bar = 0;
};

struct Errors {
  std::size_t pixels = 0;  ///< compared
  double bar = 0;          ///< the truth's; no error below it is told from none
  double rmse = 0;
  double p99 = 0;                     ///< 99 % of the pixels are off by at most this
  std::size_t wrong = 0;              ///< off by more than 1/2
  std::size_t wrong_beyond_edge = 0;  ///< those that are not at an edge
  /// RMSE where the truth is 0, between, and 1; nothing where it is so in no pixel.
  std::optional<double> umbra, penumbra, lit;
  double worst = 0;
  int worst_x = 0, worst_y = 0;  ///< from the top left

  /// Whether the RMSE is one that the truth's own error could be: then the true one is at most the
  /// bar, and nobody knows more.
  bool below_bar() const { return rmse < bar; }
};

/// Compares the pixels where `compared` is not 0; all three are of one size. A value that is not a
/// number counts as off by 1.
Errors errors_of(const image::FloatImage& technique, const Truth& truth,
                 const std::vector<std::uint8_t>& compared);

/// |technique - truth| where compared, 0 elsewhere.
image::FloatImage error_map(const image::FloatImage& technique, const Truth& truth,
                            const std::vector<std::uint8_t>& compared);

}  // namespace shadowlab::measure
