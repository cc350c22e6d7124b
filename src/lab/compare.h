// Whether a picture is right: fair to a student whose picture is drawn in another way, and blind to
// nothing that a person would see.
//
// A pixel differs when a channel is more than 3/255 from the reference (alpha is never compared), a
// stencil value at all, a depth by more than 4 of its 2^24 steps. Two ways of drawing the same
// shadow round differently, and so may disagree about pixels whose centre is on an edge: such
// pixels are forgiven, if they are within a pixel of an edge that the exact truth has, and in each
// tile of the picture at most one in ten of those (a quarter of the edge's length). What remains
// must fit a budget of one pixel in ten thousand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "image/image.h"

namespace shadowlab::lab {

inline constexpr int color_tolerance = 3;                  ///< of 255
inline constexpr float depth_tolerance = 4 / 16777215.0f;  ///< steps of 24 bits
inline constexpr int tile = 32;                            ///< pixels
inline constexpr std::size_t forgiven_one_in = 10;         ///< of a tile's pixels at an edge

/// 1 for each pixel that differs (or is at an edge), rows from the top.
using PixelMask = std::vector<std::uint8_t>;

PixelMask differing(const image::Image& a, const image::Image& b);
PixelMask differing(const image::FloatImage& a, const image::FloatImage& b);
PixelMask differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

struct Judgement {
  std::size_t differing = 0;
  std::size_t forgiven = 0;  ///< of them
  std::size_t budget = 0;    ///< what may remain
  bool fits() const { return differing - forgiven <= budget; }
};

/// How many pixels of a picture may differ anywhere: one in ten thousand.
std::size_t budget_of(std::size_t pixels);

/// `edges` gives the pixels within one of a true edge; it is asked only where that can decide. A
/// mask of another size than width × height (a picture of another size) never fits.
Judgement judge(const PixelMask& differs, int width, int height,
                const std::function<const PixelMask&()>& edges);

}  // namespace shadowlab::lab
