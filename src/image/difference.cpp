#include "image/difference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "core/error.h"

namespace shadowlab::image {
namespace {

// Pixels taken at a time: their differences stay in the first cache, so that each of the short
// loops below compiles to vector instructions; and the sum of their squares fits 32 bits.
constexpr std::size_t block_pixels = 1024;
static_assert(block_pixels * 3 * 255 * 255 < 0xFFFFFFFFu);

using Block = std::array<std::uint8_t, 4 * block_pixels>;

constexpr Block rgb_mask = [] {
  Block mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 4 == 3 ? 0 : 255;
  return mask;
}();

// |a - b| in red, green and blue; 0 in alpha and beyond `pixels`.
void subtract(const std::uint8_t* a, const std::uint8_t* b, std::size_t pixels, Block& difference) {
  if (pixels < block_pixels) difference.fill(0);
  for (std::size_t i = 0; i < 4 * pixels; ++i) {
    difference[i] = static_cast<std::uint8_t>(std::max(a[i], b[i]) - std::min(a[i], b[i]));
  }
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] &= rgb_mask[i];
}

std::uint32_t sum_of_squares(const Block& difference) {
  std::uint32_t sum = 0;
  for (const std::uint8_t d : difference) sum += static_cast<std::uint16_t>(d * d);
  return sum;
}

std::uint8_t largest(const Block& difference) {
  std::uint8_t most = 0;
  for (const std::uint8_t d : difference) most = std::max(most, d);
  return most;
}

std::size_t count_above(Block& difference, std::uint8_t tolerance) {
  for (std::uint8_t& d : difference) d = d > tolerance ? 255 : 0;
  std::array<std::uint32_t, block_pixels> words;
  std::memcpy(words.data(), difference.data(), sizeof words);
  std::uint32_t count = 0;
  for (const std::uint32_t word : words) count += word != 0;
  return count;
}

}  // namespace

void expect_one_size(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  const auto size = [](const Image& i) {
    return std::to_string(i.width) + " x " + std::to_string(i.height);
  };
  throw InputError("The pictures differ in size, " + size(a) + " and " + size(b) +
                   "; only pictures of one size can be compared.");
}

Difference compare(const Image& a, const Image& b, int tolerance) {
  expect_one_size(a, b);
  const auto limit = static_cast<std::uint8_t>(std::clamp(tolerance, 0, 255));
  Difference result;
  result.pixels = a.rgba.size() / 4;
  std::uint64_t squares = 0;
  Block difference;
  for (std::size_t first = 0; first < result.pixels; first += block_pixels) {
    const std::size_t pixels = std::min(block_pixels, result.pixels - first);
    subtract(a.rgba.data() + 4 * first, b.rgba.data() + 4 * first, pixels, difference);
    const int most = largest(difference);
    if (most == 0) continue;
    squares += sum_of_squares(difference);
    result.worst = std::max(result.worst, most);
    if (most > limit) result.differing += count_above(difference, limit);
  }
  if (result.pixels > 0) {
    const double channels = 3.0 * static_cast<double>(result.pixels);
    result.rmse = std::sqrt(static_cast<double>(squares) / channels) / 255.0;
  }
  return result;
}

}  // namespace shadowlab::image
