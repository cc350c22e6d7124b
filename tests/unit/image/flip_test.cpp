#include "image/flip.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "test_folder.h"

namespace shadowlab::image {
namespace {

constexpr int side = 64;

// The published implementation's values, printed to six digits from single precision: 1e-4 leaves
// room for that and no room for a wrong filter.
constexpr double tolerance = 1e-4;

std::array<std::uint8_t, 4> grey(int value) {
  const auto v = static_cast<std::uint8_t>(value);
  return {v, v, v, 255};
}

Image flat(std::array<std::uint8_t, 4> color) { return Image(side, side, color); }

// A square of 32 pixels on a light ground.
Image square(int left, int value) {
  Image image = flat(grey(192));
  for (int y = 16; y < 48; ++y) {
    for (int x = left; x < left + 32; ++x) image.set(x, y, grey(value));
  }
  return image;
}

void expect_flip(const Image& reference, const Image& test, double mean, double worst) {
  const Flip result = flip(reference, test);
  EXPECT_NEAR(result.mean, mean, tolerance);
  EXPECT_NEAR(result.worst, worst, tolerance);
}

TEST(Flip, of_equal_pictures_is_exactly_nothing) {
  const Flip result = flip(square(16, 64), square(16, 64));
  EXPECT_EQ(result.mean, 0);
  EXPECT_EQ(result.worst, 0);
}

TEST(Flip, of_white_against_black) {
  expect_flip(flat(grey(255)), flat(grey(0)), .967388, .967388);
}

TEST(Flip, of_pure_green_against_pure_blue_is_the_largest_there_is) {
  expect_flip(flat({0, 255, 0, 255}), flat({0, 0, 255, 255}), 1, 1);
}

TEST(Flip, of_greys_one_step_apart) {
  expect_flip(flat(grey(128)), flat(grey(129)), .029863, .029863);
}

TEST(Flip, of_a_square_shifted_by_a_pixel) {
  expect_flip(square(16, 64), square(17, 64), .030849, .537459);
}

TEST(Flip, of_a_square_that_is_missing) {
  expect_flip(square(16, 64), flat(grey(192)), .257473, .941479);
}

TEST(Flip, of_a_square_a_little_lighter) {
  expect_flip(square(16, 64), square(16, 72), .036062, .160279);
}

TEST(Flip, of_gradients_across_each_other) {
  Image a(side, side), b(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto u = static_cast<std::uint8_t>(4 * x), v = static_cast<std::uint8_t>(4 * y);
      a.set(x, y, {u, v, 128, 255});
      b.set(x, y, {v, u, 128, 255});
    }
  }
  expect_flip(a, b, .734624, .987017);
}

TEST(Flip, of_black_against_one_white_pixel) {
  Image point = flat(grey(0));
  point.set(16, 16, grey(255));
  expect_flip(flat(grey(0)), point, .003493, .864906);
}

TEST(Flip, ignores_alpha) { EXPECT_EQ(flip(flat({1, 2, 3, 0}), flat({1, 2, 3, 255})).worst, 0); }

TEST(Flip, mean_and_worst_are_those_of_the_error_picture) {
  const Flip result = flip(square(16, 64), square(17, 64));
  double sum = 0, worst = 0;
  for (const float e : result.error.values) {
    sum += static_cast<double>(e);
    worst = std::max(worst, static_cast<double>(e));
  }
  // The picture is in single precision: 6e-8 relative in each pixel, at most 1.
  EXPECT_NEAR(result.mean, sum / (side * side), 1e-7);
  EXPECT_NEAR(result.worst, worst, 1e-7);
}

// The filters are wider than such pictures: the border repeats.
TEST(Flip, works_on_a_single_pixel_and_a_line) {
  EXPECT_NEAR(flip(Image(1, 1, grey(255)), Image(1, 1, grey(0))).mean, .967388, tolerance);
  EXPECT_NEAR(flip(Image(1, 9, grey(128)), Image(1, 9, grey(129))).worst, .029863, tolerance);
}

TEST(Flip, of_pictures_of_two_sizes_is_refused) {
  EXPECT_THROW(flip(Image(2, 3), Image(3, 2)), InputError);
}

}  // namespace
}  // namespace shadowlab::image
