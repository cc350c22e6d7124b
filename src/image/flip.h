// LDR-FLIP: the difference that a person sees who flips between two pictures.
// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include "image/image.h"

namespace shadowlab::image {

/// Pixels per degree of visual angle: a 0.7 m wide display of 3840 pixels at 0.7 m, the paper's.
inline constexpr double usual_pixels_per_degree = 67.0206;

struct Flip {
  FloatImage error;  ///< of each pixel, 0 (the same) to 1
  double mean = 0;
  double worst = 0;
};

/// Compares two 8-bit sRGB pictures of one size; alpha is ignored. Throws InputError when the sizes
/// differ. Not for grading by its mean: ±1 in every pixel scores like a shadow that is a pixel off.
Flip flip(const Image& reference, const Image& test,
          double pixels_per_degree = usual_pixels_per_degree);

}  // namespace shadowlab::image
