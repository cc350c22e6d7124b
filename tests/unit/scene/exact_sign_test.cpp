#include "scene/exact_sign.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace shadowlab::scene {
namespace {

int sign(__int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

TEST(PlaneSide, of_small_integers_is_the_determinant) {
  std::mt19937 random(1);
  // A small range, so that one in a few dozen is exactly zero.
  std::uniform_int_distribution<int> coordinate(-4, 4);
  int zeros = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    __int128 m[4][3];
    for (auto& row : m) {
      for (auto& v : row) v = coordinate(random);
    }
    const int w = coordinate(random);
    __int128 e[2][3];
    for (int i = 0; i < 3; ++i) {
      e[0][i] = m[1][i] - m[0][i];
      e[1][i] = m[2][i] - m[0][i];
    }
    __int128 value = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      value += (e[0][j] * e[1][k] - e[0][k] * e[1][j]) * (m[3][i] - w * m[0][i]);
    }
    const auto row = [&](int r) {
      return glm::dvec3(static_cast<double>(m[r][0]), static_cast<double>(m[r][1]),
                        static_cast<double>(m[r][2]));
    };
    const glm::dvec4 light(row(3), w);
    zeros += value == 0 ? 1 : 0;
    ASSERT_EQ(plane_side(glm::vec3(row(0)), glm::vec3(row(1)), glm::vec3(row(2)), light),
              sign(value));
  }
  EXPECT_GT(zeros, 200);
}

TEST(PlaneSide, sees_one_ulp_beside_the_plane) {
  // The plane x + y + z = 2 (2^24 - 1).
  const float m = 16777215.0f;
  const glm::vec3 a(m, m, 0), b(0, m, m), c(m, 0, m);
  const glm::dvec4 on(m, m / 2.0, m / 2.0, 1);
  EXPECT_EQ(plane_side(a, b, c, on), 0);
  const int above = plane_side(a, b, c, {m, m, m, 1});
  ASSERT_NE(above, 0);
  for (int i = 0; i < 3; ++i) {
    glm::dvec4 up = on, down = on;
    up[i] = std::nextafter(on[i], 1e300);
    down[i] = std::nextafter(on[i], -1e300);
    EXPECT_EQ(plane_side(a, b, c, up), above);
    EXPECT_EQ(plane_side(a, b, c, down), -above);
  }
}

TEST(PlaneSide, is_exact_from_the_least_float_to_the_greatest) {
  const float least = std::numeric_limits<float>::denorm_min();
  const float most = std::numeric_limits<float>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  EXPECT_EQ(plane_side({0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, tiny, 0}), 1);
  EXPECT_EQ(plane_side({0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, -tiny, huge}), -1);
  EXPECT_EQ(plane_side({0, 0, 0}, {most, 0, 0}, {0, most, 0}, {huge, huge, tiny, 1}), 1);
  EXPECT_EQ(plane_side({-most, -most, 0}, {most, -most, 0}, {0, most, 0}, {huge, huge, -tiny, 1}),
            -1);
  EXPECT_EQ(plane_side({-most, -most, 0}, {most, -most, 0}, {0, most, 0}, {huge, -huge, 0, huge}),
            0);
  EXPECT_EQ(plane_side({0, 0, least}, {most, 0, least}, {0, most, least}, {0, 0, 1e-45, 1}), -1);
}

TEST(PlaneSide, of_almost_coplanar_points_changes_with_each_exchange) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    glm::vec3 p[4];
    for (auto& v : p) v = {coordinate(random), coordinate(random), coordinate(random)};
    // The nearest float point to one of the plane; stored, since GCC 12 forgets the rounding of a
    // double to float and back when it vectorizes straight-line code.
    for (int i = 0; i < 3; ++i) {
      volatile float stored = static_cast<float>(p[0][i] * 0.25 + p[1][i] * 0.4 + p[2][i] * 0.35);
      p[3][i] = stored;
    }
    const auto side = [&](int i, int j, int k, int l) {
      return plane_side(p[i], p[j], p[k], glm::dvec4(p[l], 1));
    };
    const int s = side(0, 1, 2, 3);
    ASSERT_EQ(side(1, 2, 0, 3), s);
    ASSERT_EQ(side(1, 0, 2, 3), -s);
    ASSERT_EQ(side(0, 1, 3, 2), -s);
    ASSERT_EQ(side(3, 1, 2, 0), -s);
    ASSERT_EQ(side(1, 0, 3, 2), s);
  }
}

TEST(Collinear, is_exact) {
  EXPECT_TRUE(collinear({1, 2, 3}, {1, 2, 3}, {5, 6, 7}));
  EXPECT_TRUE(collinear({0, 0, 0}, {0.1f, 0.1f, 0.1f}, {0.3f, 0.3f, 0.3f}));
  EXPECT_TRUE(collinear({0, 0, 0}, {1, 3, 5}, {16777216, 50331648, 83886080}));
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 3, 5}, {16777216, 50331648, 83886088}));
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 0, 0}, {0.5f, 1e-45f, 0}));
  EXPECT_FALSE(collinear({1e-45f, 0, 0}, {0, 1e-45f, 0}, {0, 0, 1e-45f}));
  EXPECT_FALSE(collinear({3e38f, 0, 0}, {-3e38f, 0, 0}, {0, 1e-45f, 0}));
}

}  // namespace
}  // namespace shadowlab::scene
