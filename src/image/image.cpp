#include "image/image.h"

#include <algorithm>

namespace shadowlab::image {
namespace {

std::size_t offset(const Image& image, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x));
}

}  // namespace

Image::Image(int w, int h, std::array<std::uint8_t, 4> fill)
    : width(w),
      height(h),
      rgba(std::size_t{4} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) std::copy_n(fill.data(), 4, rgba.data() + i);
}

std::array<std::uint8_t, 4> Image::at(int x, int y) const {
  const std::uint8_t* pixel = rgba.data() + offset(*this, x, y);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

void Image::set(int x, int y, std::array<std::uint8_t, 4> color) {
  std::copy_n(color.data(), 4, rgba.data() + offset(*this, x, y));
}

}  // namespace shadowlab::image
