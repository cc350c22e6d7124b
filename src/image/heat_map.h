// Where two pictures differ, for the eye.
#pragma once

#include "image/image.h"

namespace shadowlab::image {

/// The colour of an error in [0, 1]: violet, magenta, orange, yellow, white, ever brighter. Even
/// the least error stands out from heat_map's dark ground.
std::array<std::uint8_t, 4> heat_color(double error);

/// Pixels whose largest channel difference d (alpha ignored) exceeds `tolerance` in heat_color(√(d
/// / 255)), so that a difference of 1 and one of 2 are told apart; the others show `a` in dark
/// grey. Throws InputError when the sizes differ.
Image heat_map(const Image& a, const Image& b, int tolerance = 0);

/// Each error of [0, 1] in heat_color, and 0 in black.
Image heat_map(const FloatImage& error);

}  // namespace shadowlab::image
