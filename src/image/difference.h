// How far two pictures are apart. All of them ignore alpha: a frame's alpha is a means (blending,
// masks), and no screen shows it.
#pragma once

#include <cstddef>

#include "image/image.h"

namespace shadowlab::image {

struct Difference {
  double rmse = 0;            ///< root mean square over red, green, blue, each in [0, 1]
  int worst = 0;              ///< the largest difference of a channel, 0 to 255
  std::size_t differing = 0;  ///< pixels with a channel that differs by more than the tolerance
  std::size_t pixels = 0;     ///< pixels compared
};

/// Compares two pictures of one size. `tolerance` is in steps of 8 bits, 0 to 255. Exact and the
/// same on every machine, since the sums are of integers. Throws InputError when the sizes differ.
Difference compare(const Image& a, const Image& b, int tolerance = 0);

/// Throws InputError, one sentence that names both sizes, when they differ.
void expect_one_size(const Image& a, const Image& b);

}  // namespace shadowlab::image
