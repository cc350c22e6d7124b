#include "image/difference.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "image/heat_map.h"
#include "test_folder.h"

namespace shadowlab::image {
namespace {

TEST(Difference, of_equal_pictures_is_nothing) {
  const Image a(30, 20, {1, 2, 3, 4});
  const Difference d = compare(a, a);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_EQ(d.worst, 0);
  EXPECT_EQ(d.differing, 0u);
  EXPECT_EQ(d.pixels, 600u);
}

TEST(Difference, of_black_and_white_is_one) {
  const Difference d = compare(Image(30, 20, {0, 0, 0, 255}), Image(30, 20, {255, 255, 255, 255}));
  EXPECT_EQ(d.rmse, 1);
  EXPECT_EQ(d.worst, 255);
  EXPECT_EQ(d.differing, 600u);
}

// The sum of squares is an integer, so the root of it is the same double whatever the order.
TEST(Difference, is_the_root_of_the_mean_square_of_the_channels) {
  Image a(3, 2), b(3, 2);
  b.set(1, 1, {3, 0, 4, 255});
  b.set(2, 0, {0, 12, 0, 255});
  const Difference d = compare(a, b);
  EXPECT_EQ(d.rmse, std::sqrt((9.0 + 16.0 + 144.0) / 18.0) / 255.0);
  EXPECT_EQ(d.worst, 12);
  EXPECT_EQ(d.differing, 2u);
}

TEST(Difference, does_not_depend_on_which_is_first) {
  Image a(3, 1, {10, 20, 30, 255}), b(3, 1, {30, 20, 10, 255});
  EXPECT_EQ(compare(a, b).rmse, compare(b, a).rmse);
  EXPECT_EQ(compare(a, b).worst, 20);
  EXPECT_EQ(compare(b, a).worst, 20);
}

TEST(Difference, counts_pixels_with_a_channel_beyond_the_tolerance) {
  const Image a(4, 1, {100, 100, 100, 255});
  Image b = a;
  b.set(0, 0, {100, 101, 100, 255});
  b.set(1, 0, {102, 102, 102, 255});
  b.set(2, 0, {100, 100, 97, 255});
  EXPECT_EQ(compare(a, b, 0).differing, 3u);
  EXPECT_EQ(compare(a, b, 1).differing, 2u);
  EXPECT_EQ(compare(a, b, 2).differing, 1u);
  EXPECT_EQ(compare(a, b, 3).differing, 0u);
  EXPECT_EQ(compare(a, b, 3).worst, 3);
}

TEST(Difference, ignores_alpha) {
  const Difference d = compare(Image(5, 5, {1, 2, 3, 0}), Image(5, 5, {1, 2, 3, 255}));
  EXPECT_EQ(d.worst, 0);
  EXPECT_EQ(d.differing, 0u);
}

// Pixels are taken 1024 at a time: sizes at and about that border, the difference in the last
// pixel.
TEST(Difference, sees_the_last_pixel_of_any_size) {
  for (const int width : {1, 2, 15, 1023, 1024, 1025, 2047, 2048, 2049}) {
    Image a(width, 1), b(width, 1);
    b.set(width - 1, 0, {0, 0, 9, 255});
    const Difference d = compare(a, b);
    EXPECT_EQ(d.worst, 9) << width;
    EXPECT_EQ(d.differing, 1u) << width;
    EXPECT_EQ(d.rmse, std::sqrt(81.0 / (3.0 * width)) / 255.0) << width;
  }
}

TEST(Difference, of_pictures_of_two_sizes_names_both) {
  EXPECT_EQ(message_of<InputError>([] { compare(Image(64, 32), Image(32, 64)); }),
            "The pictures differ in size, 64 x 32 and 32 x 64; only pictures of one size can be "
            "compared.");
}

TEST(HeatMap, shows_any_difference_brighter_than_any_equality) {
  const Image a(2, 1, {255, 255, 255, 255});
  Image b = a;
  b.set(0, 0, {255, 254, 255, 255});
  const Image heat = heat_map(a, b);
  const auto differing = heat.at(0, 0), equal = heat.at(1, 0);
  EXPECT_GT(differing[0] + differing[1] + differing[2], 2 * (equal[0] + equal[1] + equal[2]));
  EXPECT_EQ(equal[0], equal[1]);
  EXPECT_EQ(equal[0], equal[2]);
}

TEST(HeatMap, leaves_out_what_is_within_the_tolerance) {
  const Image a(1, 1, {100, 100, 100, 255}), b(1, 1, {102, 100, 100, 255});
  EXPECT_EQ(heat_map(a, b, 2), heat_map(a, a));
  EXPECT_NE(heat_map(a, b, 1), heat_map(a, a));
}

TEST(HeatMap, grows_brighter_with_the_error) {
  const auto luma = [](double error) {
    const auto c = heat_color(error);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  // Fifty steps: a finer one can be lost to the rounding of a channel.
  for (int i = 0; i < 50; ++i) EXPECT_LT(luma(i / 50.0), luma((i + 1) / 50.0)) << i;
}

TEST(HeatMap, of_an_error_picture_is_black_where_there_is_none) {
  const Image heat = heat_map(FloatImage{3, 1, {0.f, 1e-6f, 1.f}});
  EXPECT_EQ(heat.at(0, 0), (std::array<std::uint8_t, 4>{0, 0, 0, 255}));
  EXPECT_EQ(heat.at(1, 0), heat_color(1e-6));
  EXPECT_EQ(heat.at(2, 0), heat_color(1));
}

}  // namespace
}  // namespace shadowlab::image
