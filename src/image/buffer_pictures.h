// Depth and stencil for the eye.
#pragma once

#include <array>
#include <cstdint>

#include "image/image.h"

namespace shadowlab::image {

/// A colour for each stencil value, distinct for neighbours; 0 is black.
std::array<std::uint8_t, 4> stencil_color(std::uint8_t value);

/// Depths as greys over their range; the far plane's 1.0 white.
Image depth_picture(const FloatImage& depth);

}  // namespace shadowlab::image
