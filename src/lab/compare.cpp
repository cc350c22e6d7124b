#include "lab/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace shadowlab::lab {
namespace {

// Every pixel of a picture that is not there, or of another size, differs.
PixelMask all(std::size_t pixels) { return PixelMask(pixels, 1); }

std::size_t marked(const PixelMask& mask) {
  return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), std::uint8_t{1}));
}

}  // namespace

PixelMask differing(const image::Image& a, const image::Image& b) {
  const std::size_t pixels = a.rgba.size() / 4;
  if (a.width != b.width || a.height != b.height || b.rgba.size() != a.rgba.size())
    return all(pixels);
  PixelMask mask(pixels);
  if (a.rgba == b.rgba) return mask;  // most submissions are right, and right to the last bit
  for (std::size_t i = 0; i < pixels; ++i) {
    if (std::memcmp(&a.rgba[4 * i], &b.rgba[4 * i], 4) == 0) continue;
    int worst = 0;
    for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
      worst = std::max(worst, std::abs(int{a.rgba[c]} - int{b.rgba[c]}));
    mask[i] = worst > color_tolerance;
  }
  return mask;
}

PixelMask differing(const image::FloatImage& a, const image::FloatImage& b) {
  if (a.width != b.width || a.height != b.height || a.values.size() != b.values.size())
    return all(a.values.size());
  PixelMask mask(a.values.size());
  // Written so that what is not a number differs.
  for (std::size_t i = 0; i < mask.size(); ++i)
    mask[i] = !(std::abs(a.values[i] - b.values[i]) <= depth_tolerance);
  return mask;
}

PixelMask differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  if (a.size() != b.size()) return all(a.size());
  PixelMask mask(a.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = a[i] != b[i];
  return mask;
}

std::size_t budget_of(std::size_t pixels) { return pixels / 10'000; }

Judgement judge(const PixelMask& differs, int width, int height,
                const std::function<const PixelMask&()>& edges) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Judgement judgement{marked(differs), 0, budget_of(pixels)};
  if (judgement.fits() || differs.size() != pixels) return judgement;
  // Were every pixel at an edge, no more than this would be forgiven.
  if (judgement.differing > judgement.budget + pixels / forgiven_one_in) return judgement;
  const PixelMask& near = edges();
  if (near.size() != pixels) return judgement;
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  for (std::size_t top = 0; top < h; top += tile) {
    for (std::size_t left = 0; left < w; left += tile) {
      std::size_t at_edges = 0, differing_there = 0;
      for (std::size_t y = top; y < std::min(h, top + tile); ++y) {
        for (std::size_t x = left; x < std::min(w, left + tile); ++x) {
          at_edges += near[y * w + x];
          differing_there += near[y * w + x] & differs[y * w + x];
        }
      }
      judgement.forgiven += std::min(differing_there, at_edges / forgiven_one_in);
    }
  }
  return judgement;
}

}  // namespace shadowlab::lab
