// What is forgiven, and what is not.
#include "lab/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shadowlab::lab {
namespace {

constexpr int side = 256;  // 65536 pixels: a budget of 6
constexpr std::size_t pixels = side * side;

image::Image grey(std::uint8_t value) {
  return image::Image(side, side, {value, value, value, 255});
}

std::size_t count(const PixelMask& mask) {
  return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1));
}

Judgement judged(const PixelMask& differs, const PixelMask& edges) {
  return judge(differs, side, side, [&]() -> const PixelMask& { return edges; });
}
Judgement judged_without_edges(const PixelMask& differs) {
  return judged(differs, PixelMask(pixels));
}

// Pixels within one of a vertical edge between x - 1 and x.
PixelMask edge_at(int x) {
  PixelMask mask(pixels);
  for (int y = 0; y < side; ++y) mask[static_cast<std::size_t>(y * side + x - 1)] = 1;
  for (int y = 0; y < side; ++y) mask[static_cast<std::size_t>(y * side + x)] = 1;
  return mask;
}

// The first `number` pixels of the column.
PixelMask column(int x, int number) {
  PixelMask mask(pixels);
  for (int y = 0; y < number; ++y) mask[static_cast<std::size_t>(y * side + x)] = 1;
  return mask;
}

TEST(Compare, a_channel_may_be_three_steps_off) {
  EXPECT_EQ(count(differing(grey(100), grey(103))), 0u);
  EXPECT_EQ(count(differing(grey(100), grey(97))), 0u);
  EXPECT_EQ(count(differing(grey(100), grey(104))), pixels);
}

TEST(Compare, alpha_is_not_compared) {
  image::Image clear = grey(100);
  for (std::size_t i = 3; i < clear.rgba.size(); i += 4) clear.rgba[i] = 0;
  EXPECT_EQ(count(differing(grey(100), clear)), 0u);
}

TEST(Compare, a_stencil_is_exact) {
  const std::vector<std::uint8_t> a(pixels, 1);
  auto b = a;
  b[7] = 2;
  EXPECT_EQ(count(differing(a, b)), 1u);
}

TEST(Compare, a_depth_may_be_four_of_its_steps_off) {
  const float step = 1 / 16777215.0f;
  image::FloatImage a{2, 1, {0.5f, 0.5f}}, b{2, 1, {0.5f + 3 * step, 0.5f + 8 * step}};
  EXPECT_EQ(differing(a, b), (PixelMask{0, 1}));
  b.values = {std::numeric_limits<float>::quiet_NaN(), 0.5f};
  EXPECT_EQ(differing(a, b), (PixelMask{1, 0}));
}

TEST(Compare, a_picture_of_another_size_is_wrong_everywhere) {
  const PixelMask differs = differing(grey(1), image::Image(3, 3));
  EXPECT_EQ(count(differs), pixels);
  EXPECT_FALSE(judged_without_edges(differs).fits());
}

TEST(Compare, one_pixel_in_ten_thousand_may_differ_anywhere) {
  EXPECT_TRUE(judged_without_edges(column(9, 6)).fits());
  EXPECT_FALSE(judged_without_edges(column(9, 7)).fits());
}

// A tile of 32 × 32 has 64 pixels at the edge: one in ten is 6.
TEST(Compare, at_an_edge_a_tenth_of_each_tile_is_forgiven_beside) {
  const PixelMask edges = edge_at(100);
  EXPECT_TRUE(judged(column(100, 6 + 6), edges).fits());
  EXPECT_FALSE(judged(column(100, 6 + 7), edges).fits());
  EXPECT_EQ(judged(column(100, 256), edges).forgiven, 8u * 6);
}

TEST(Compare, beyond_a_pixel_of_an_edge_nothing_is_forgiven) {
  EXPECT_FALSE(judged(column(101, 12), edge_at(100)).fits());
}

TEST(Compare, a_shadow_that_is_a_pixel_off_is_wrong) {
  EXPECT_FALSE(judged(column(100, side), edge_at(100)).fits());
  EXPECT_FALSE(judged(column(100, side / 2), edge_at(100)).fits());
}

// An allowance for the whole picture would let a short piece of shadow go.
TEST(Compare, a_long_edge_elsewhere_forgives_nothing_here) {
  PixelMask edges(pixels);
  for (int x = 110; x < 250; x += 3) {
    const PixelMask one = edge_at(x);
    for (std::size_t i = 0; i < pixels; ++i) edges[i] |= one[i];
  }
  const PixelMask here = edge_at(20);
  for (std::size_t i = 0; i < pixels; ++i) edges[i] |= here[i];
  EXPECT_FALSE(judged(column(20, 32), edges).fits());
}

TEST(Compare, the_truth_is_not_traced_where_it_cannot_decide) {
  const auto unwanted = []() -> const PixelMask& {
    ADD_FAILURE() << "traced";
    static const PixelMask none;
    return none;
  };
  EXPECT_TRUE(judge(PixelMask(pixels), side, side, unwanted).fits());
  EXPECT_FALSE(judge(PixelMask(pixels, 1), side, side, unwanted).fits());
}

}  // namespace
}  // namespace shadowlab::lab
