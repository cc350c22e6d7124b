#include "image/heat_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/difference.h"

namespace shadowlab::image {
namespace {

using Color = std::array<std::uint8_t, 4>;

// Luma (Rec. 709 weights in 1/256) at a fifth, so that at most 51: heat colours start brighter.
Color dark_grey(const std::uint8_t* pixel) {
  const unsigned luma = (54u * pixel[0] + 183u * pixel[1] + 19u * pixel[2]) / 256u;
  const auto grey = static_cast<std::uint8_t>(luma / 5);
  return {grey, grey, grey, 255};
}

int largest_channel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

Color heat_color(double error) {
  constexpr std::array<std::array<double, 3>, 5> scale = {
      {{88, 48, 224}, {200, 48, 200}, {255, 112, 48}, {255, 216, 64}, {255, 255, 240}}};
  const double at = std::clamp(error, 0.0, 1.0) * (scale.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), scale.size() - 2);
  const double part = at - static_cast<double>(below);
  Color color{0, 0, 0, 255};
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = static_cast<std::uint8_t>(
        std::lround(scale[below][i] + part * (scale[below + 1][i] - scale[below][i])));
  }
  return color;
}

Image heat_map(const Image& a, const Image& b, int tolerance) {
  expect_one_size(a, b);
  std::array<Color, 256> colors;
  for (std::size_t d = 0; d < colors.size(); ++d) {
    colors[d] = heat_color(std::sqrt(static_cast<double>(d) / 255.0));
  }
  Image heat(a.width, a.height);
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const int d = largest_channel_difference(a.rgba.data() + i, b.rgba.data() + i);
    const Color color =
        d > tolerance ? colors[static_cast<std::size_t>(d)] : dark_grey(a.rgba.data() + i);
    std::copy_n(color.data(), 4, heat.rgba.data() + i);
  }
  return heat;
}

Image heat_map(const FloatImage& error) {
  Image heat(error.width, error.height);
  for (std::size_t i = 0; i < error.values.size(); ++i) {
    if (!(error.values[i] > 0)) continue;
    const Color color = heat_color(static_cast<double>(error.values[i]));
    std::copy_n(color.data(), 4, heat.rgba.data() + 4 * i);
  }
  return heat;
}

}  // namespace shadowlab::image
