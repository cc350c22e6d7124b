#include "image/buffer_pictures.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::image {

std::array<std::uint8_t, 4> stencil_color(std::uint8_t value) {
  if (value == 0) return {0, 0, 0, 255};
  // Hues a golden angle apart, so that neighbouring values differ most; lightness in three steps.
  const double hue = std::fmod(value * 0.61803398875, 1.0) * 6;
  const double light = 0.65 + 0.175 * (value % 3);
  std::array<double, 3> rgb{std::abs(hue - 3) - 1, 2 - std::abs(hue - 2), 2 - std::abs(hue - 4)};
  std::array<std::uint8_t, 4> color{0, 0, 0, 255};
  for (std::size_t i = 0; i < 3; ++i) {
    const double saturated = std::clamp(rgb[i], 0.0, 1.0);
    color[i] = static_cast<std::uint8_t>(std::lround(255 * light * (0.15 + 0.85 * saturated)));
  }
  return color;
}

Image depth_picture(const FloatImage& depth) {
  float nearest = 1, farthest = 0;
  for (const float value : depth.values) {
    if (value >= 1) continue;
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  const float range = farthest > nearest ? farthest - nearest : 1;
  Image picture(depth.width, depth.height);
  for (std::size_t i = 0; i < depth.values.size(); ++i) {
    const float value = depth.values[i];
    // The nearest is not quite black, so that it differs from a missing picture.
    const float grey = value >= 1 ? 1.0f : 0.1f + 0.75f * (value - nearest) / range;
    const auto level = static_cast<std::uint8_t>(std::lround(255 * grey));
    std::fill_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(i * 4), 3, level);
  }
  return picture;
}

}  // namespace shadowlab::image
