// A technique's visibility against the truth: the row of the check table.
#pragma once

#include <cstddef>

#include "image/image.h"

namespace shadowlab::truth {

struct Comparison {
  std::size_t pixels = 0;             ///< compared: all of them
  std::size_t wrong = 0;              ///< |technique - truth| > tolerance
  std::size_t wrong_beyond_edge = 0;  ///< wrong, and not marked in the edge mask
  std::size_t edge_pixels = 0;        ///< marked in the edge mask
  double rmse = 0;                    ///< root mean square difference over all pixels
  double worst = 0;                   ///< largest difference
};

/// Compares pictures of one size (else InputError). The tolerance of 1/2 counts hard shadows whose
/// pixels are 0 or 1. A value that is not a number counts as wrong, with a difference of 1.
Comparison compare(const image::FloatImage& technique, const image::FloatImage& truth,
                   const image::FloatImage& edge_mask, double tolerance = 0.5);

}  // namespace shadowlab::truth
