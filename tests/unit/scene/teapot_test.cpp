#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/mesh.h"
#include "scene/teapot_patches.h"
#include "topology.h"

namespace shadowlab::scene {
namespace {

constexpr double newell_height = 3.15;

/// The extreme of a cubic Bézier coordinate whose derivative has one root in (0, 1).
double cubic_extreme(double a, double b, double c, double d) {
  const double p = b - a, q = c - b, r = d - c;  // derivative / 3: p s² + 2 q s t + r t²
  const double t = (p - q - std::sqrt(q * q - p * r)) / (p - 2.0 * q + r);
  const double s = 1.0 - t;
  return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

std::vector<std::array<glm::dvec3, 4>> borders(const newell::Patch& p) {
  std::vector<std::array<glm::dvec3, 4>> all{p[0], p[3]};
  for (const std::size_t column : {0u, 3u}) {
    all.push_back({p[0][column], p[1][column], p[2][column], p[3][column]});
  }
  return all;
}

TEST(Teapot, has_the_290_distinct_control_points_of_newells_table) {
  std::set<std::array<double, 3>> points;
  for (const newell::Patch& patch : newell::patches()) {
    for (const auto& row : patch) {
      for (const glm::dvec3& p : row) points.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    }
  }
  EXPECT_EQ(points.size(), 290u);
}

TEST(Teapot, patches_share_their_borders_in_the_same_order_except_where_newells_is_open) {
  // A border that has shrunk to a point (the knob's top and the middle of the bottom) is no border.
  using Border = std::array<std::array<double, 3>, 4>;
  std::map<Border, int> shared;
  for (const newell::Patch& patch : newell::patches()) {
    for (const auto& border : borders(patch)) {
      if (border[0] == border[3]) continue;
      Border points;
      for (std::size_t i = 0; i < 4; ++i) {
        points[i] = {border[i].x + 0.0, border[i].y + 0.0, border[i].z + 0.0};
      }
      ++shared[points];
    }
  }
  int open = 0;
  for (const auto& [border, count] : shared) {
    EXPECT_LE(count, 2);
    open += count == 1;
  }
  // The lid's edge and the rim's (4 each), and both ends of the handle and of the spout (2 each),
  // whose halves' borders end on the same two points.
  EXPECT_EQ(open, 4 + 4 + 4 * 2);
}

TEST(Teapot, is_as_large_as_newells) {
  const Bounds box = bounds(teapot(newell_height, 64));
  // Float positions; the spout's lip reaches its furthest between two vertices of 1/64: 1e-4 short.
  EXPECT_NEAR(box.low.x, -3.0, 1e-6);
  EXPECT_NEAR(box.high.x, cubic_extreme(3.3, 3.525, 3.45, 3.2), 1e-4);
  EXPECT_EQ(box.low.y, 0.0);
  EXPECT_NEAR(box.high.y, 3.15, 1e-6);
  EXPECT_NEAR(box.low.z, -2.0, 1e-6);
  EXPECT_NEAR(box.high.z, 2.0, 1e-6);
}

TEST(Teapot, stands_on_y_0_and_is_as_high_as_asked) {
  for (const double size : {1.0, 0.25, 7.0}) {
    EXPECT_EQ(bounds(teapot(size)).low.y, 0.0);
    EXPECT_EQ(bounds(teapot(size)).high.y, size);
  }
}

TEST(Teapot, is_open_at_lid_rim_handle_and_spout_only) {
  for (const int divisions : {1, 2, 3, 8, 13}) {
    const Mesh mesh = teapot(1.0, divisions);
    // 16 open patch borders, see above, `divisions` edges each. The tips of one division are flat:
    // both halves of an end have the same two ends, and their edges cancel.
    const int expected = divisions == 1 ? 8 : 16 * divisions;
    EXPECT_EQ(open_edges(mesh), expected) << divisions;
  }
}

TEST(Teapot, has_no_degenerate_triangle_and_finite_unit_normals) {
  for (const int divisions : {1, 2, 3, 8, 13}) {
    const Mesh mesh = teapot(1.0, divisions);
    EXPECT_NO_THROW(check(mesh));
    EXPECT_EQ(degenerate_triangles(mesh), 0) << divisions;
    // Each quad at the knob's top and at the middle of the bottom has one triangle only; of one
    // division, the two quads of the spout's lip are segments.
    const int missing = 8 * divisions + (divisions == 1 ? 4 : 0);
    EXPECT_EQ(mesh.triangle_count(),
              static_cast<std::size_t>(2 * divisions * divisions * 32 - missing));
    for (const glm::vec3& n : mesh.normals) {
      EXPECT_NEAR(glm::length(glm::dvec3(n)), 1.0, 2e-7);  // float normals
    }
  }
}

TEST(Teapot, triangles_are_counter_clockwise_from_the_side_of_their_normals) {
  EXPECT_GT(least_normal_agreement(teapot(1.0, 16)), 0.0);
}

TEST(Teapot, faces_outward_at_body_lid_bottom_handle_and_spout) {
  const Mesh mesh = teapot(newell_height, 8);
  const auto expect_outward = [&](std::size_t first_patch, std::size_t last_patch, auto axis) {
    for (std::size_t i = first_patch * 81; i < (last_patch + 1) * 81; ++i) {
      const glm::dvec3 p = mesh.positions[i];
      if (p == axis(p)) continue;
      EXPECT_GT(glm::dot(p - axis(p), glm::dvec3(mesh.normals[i])), 0.0) << "patch " << i / 81;
    }
  };
  // The lid, the belly and the foot: away from the middle of the body. Knob's top up, bottom down.
  expect_outward(4, 7, [](glm::dvec3) { return glm::dvec3(0, 1.0, 0); });
  expect_outward(12, 19, [](glm::dvec3) { return glm::dvec3(0, 1.0, 0); });
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.normals[23 * 81 + 80], glm::vec3(0, -1, 0));
  // Handle and spout: away from the plane of symmetry; the spout's lip (30, 31) turns inside, and
  // agrees with the rest along their common borders, as the open edges tell.
  expect_outward(24, 29, [](glm::dvec3 p) { return glm::dvec3(p.x, p.y, 0.0); });
}

TEST(Teapot, refuses_nonsense) {
  EXPECT_THROW(teapot(0.0), InputError);
  EXPECT_THROW(teapot(1.0, 0), InputError);
  EXPECT_THROW(teapot(1.0, 129), InputError);
}

}  // namespace
}  // namespace shadowlab::scene
