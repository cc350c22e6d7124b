#include "truth/closed_forms.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"

namespace shadowlab::truth {
namespace {

// Midpoint sums over the light, with the segment from receiver to light carried to the caster's
// plane: the definition that each closed form integrates. `hides(x, z)`: whether the caster is
// there.
template <typename Hides, typename InLight>
double by_summation(glm::dvec2 receiver, Heights heights, glm::dvec2 light_center,
                    glm::dvec2 light_half, Hides hides, InLight in_light) {
  constexpr int kCells = 1000;
  const double share = heights.caster / heights.light;
  int seen = 0, all = 0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const glm::dvec2 unit((2 * i + 1.0) / kCells - 1, (2 * j + 1.0) / kCells - 1);
      if (!in_light(unit)) continue;
      ++all;
      const glm::dvec2 light = light_center + light_half * unit;
      seen += !hides(receiver + (light - receiver) * share);
    }
  }
  return static_cast<double>(seen) / all;
}

const auto kSquare = [](glm::dvec2) { return true; };
const auto kDisk = [](glm::dvec2 p) { return glm::dot(p, p) <= 1; };
// The midpoint rule misplaces an edge by at most half a cell of 1/1000 across the light, and a
// slanted one by the cells it cuts.
constexpr double kSummation = 2e-3;

TEST(ClosedForms, a_penumbra_has_half_width_s_h_over_H_minus_h) {
  EXPECT_DOUBLE_EQ(penumbra_half_width(0.5, {1, 4}), 0.5 / 3);
  EXPECT_DOUBLE_EQ(penumbra_half_width(0.5, {0, 4}), 0);
  EXPECT_DOUBLE_EQ(penumbra_half_width(0, {1, 4}), 0);
}

TEST(ClosedForms, a_half_plane_gives_the_sum_over_the_light) {
  const Heights heights{1, 3};
  const double s = 0.6, edge = 0.2, light = -0.4;
  const double p = penumbra_half_width(s, heights);
  const double from = projected_edge(edge, light, heights);
  const auto hides = [&](glm::dvec2 c) { return c.x < edge; };
  for (const double x : {-0.2, 0.1, 0.3, 0.45, 0.5, 0.62, 0.9, 1.5}) {
    EXPECT_NEAR(half_plane_under_rectangle(x - from, p),
                by_summation({x, 0}, heights, {light, 0}, {s, s}, hides, kSquare), kSummation);
    EXPECT_NEAR(half_plane_under_disk(x - from, p),
                by_summation({x, 0}, heights, {light, 0}, {s, s}, hides, kDisk), kSummation);
  }
}

TEST(ClosedForms, a_rectangle_gives_the_sum_over_the_light) {
  const Heights heights{2, 3};
  const glm::dvec2 low(-0.3, -0.1), high(0.4, 0.2), center(0.1, -0.2), half(0.5, 0.3);
  const auto hides = [&](glm::dvec2 c) {
    return c.x >= low.x && c.x <= high.x && c.y >= low.y && c.y <= high.y;
  };
  for (const double x : {-1.5, -0.7, -0.1, 0.3, 1.2}) {
    for (const double z : {-0.9, 0.1, 0.8}) {
      EXPECT_NEAR(rectangle_under_rectangle({x, z}, low, high, center, half, heights),
                  by_summation({x, z}, heights, center, half, hides, kSquare), 2 * kSummation);
    }
  }
}

TEST(ClosedForms, a_corner_of_a_large_rectangle_is_the_product_of_its_two_ramps) {
  const Heights heights{1, 3};
  const double p = penumbra_half_width(0.5, heights);
  const double far = 100;
  for (const double x : {-0.3, -0.1, 0.0, 0.2}) {
    for (const double z : {-0.2, 0.1}) {
      const double rx = half_plane_under_rectangle(x, p), rz = half_plane_under_rectangle(z, p);
      EXPECT_NEAR(
          rectangle_under_rectangle({x, z}, {-far, -far}, {0, 0}, {0, 0}, {0.5, 0.5}, heights),
          1 - (1 - rx) * (1 - rz), 1e-12);  // rounding
    }
  }
}

TEST(ClosedForms, a_disk_gives_the_sum_over_the_light) {
  const Heights heights{1, 2.5};
  for (const double radius : {0.2, 0.7}) {
    for (const double light : {0.3, 0.9}) {
      const auto hides = [&](glm::dvec2 c) { return glm::length(c) < radius; };
      for (const double d : {0.0, 0.1, 0.3, 0.7, 1.1, 2.0}) {
        EXPECT_NEAR(disk_under_disk(d, radius, light, heights),
                    by_summation({d, 0}, heights, {0, 0}, {light, light}, hides, kDisk),
                    kSummation);
      }
    }
  }
}

TEST(ClosedForms, the_rings_of_a_disk_are_where_its_visibility_reaches_0_and_1) {
  const Heights heights{1, 3};
  const DiskShadow shadow = disk_under_disk(0.5, 0.3, heights);
  EXPECT_DOUBLE_EQ(shadow.umbra, 0.5 + 0.2 / 2);
  EXPECT_DOUBLE_EQ(shadow.penumbra, 0.5 + 0.8 / 2);
  EXPECT_EQ(shadow.antumbra, 0);
  EXPECT_EQ(disk_under_disk(shadow.umbra - 1e-9, 0.5, 0.3, heights), 0);
  EXPECT_GT(disk_under_disk(shadow.umbra + 1e-3, 0.5, 0.3, heights), 0);
  EXPECT_EQ(disk_under_disk(shadow.penumbra + 1e-9, 0.5, 0.3, heights), 1);
  EXPECT_LT(disk_under_disk(shadow.penumbra - 1e-3, 0.5, 0.3, heights), 1);
}

TEST(ClosedForms, a_light_larger_than_the_caster_leaves_no_umbra) {
  const DiskShadow shadow = disk_under_disk(0.1, 1.0, {2, 3});
  EXPECT_EQ(shadow.umbra, 0);
  EXPECT_GT(shadow.antumbra, 0);
  // The caster of radius 0.1 is thrown back to 0.15 on the light: 1 - 0.15².
  EXPECT_DOUBLE_EQ(disk_under_disk(0, 0.1, 1.0, {2, 3}), 1 - 0.15 * 0.15);
}

TEST(ClosedForms, become_the_hard_shadow_as_the_light_shrinks_or_the_caster_touches) {
  for (const double s : {1e-3, 1e-6, 0.0}) {
    const double p = penumbra_half_width(s, {1, 3});
    EXPECT_EQ(half_plane_under_rectangle(0.01, p), 1);
    EXPECT_EQ(half_plane_under_disk(-0.01, p), 0);
    EXPECT_EQ(disk_under_disk(0.74, 0.5, s, {1, 3}), 0);  // thrown to 0.75
    EXPECT_EQ(disk_under_disk(0.76, 0.5, s, {1, 3}), 1);
  }
  EXPECT_EQ(rectangle_under_rectangle({0.5, 0.5}, {0, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 3}), 0);
  EXPECT_EQ(rectangle_under_rectangle({1.001, 0.5}, {0, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 3}), 1);
}

TEST(ClosedForms, refuse_a_caster_that_is_not_under_the_light) {
  EXPECT_THROW(penumbra_half_width(1, {3, 3}), InputError);
  EXPECT_THROW(disk_under_disk(1, 1, {-1, 3}), InputError);
}

}  // namespace
}  // namespace shadowlab::truth
