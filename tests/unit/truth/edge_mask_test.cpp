#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scenes.h"
#include "truth/comparison.h"
#include "truth/tracer.h"

namespace shadowlab::truth {
namespace {

using scene::Role;

TEST(EdgeMask, marks_the_pixels_within_one_pixel_of_a_shadow_edge_and_no_others) {
  scene::Scene scene;
  // A caster that covers x < 0.1 of the floor under a light straight above its edge, out of sight.
  scene.objects = {floor_object(), slab(1, {-9, -9}, {0.1, 9})};
  const Tracer tracer(scene);
  scene::Camera camera = above(4);
  camera.near = 999.5;
  const int n = 40;  // pixels of 0.1: the edge at x = 0.1 is in column 21.0
  const image::FloatImage mask = tracer.edge_mask(camera, point_light({0.1, 4, 0}), n, n);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const double away = std::abs(x + 0.5 - 21.0);
      const float value = mask.values[static_cast<std::size_t>(y * n + x)];
      // 1e-6: the slab's edge is the float nearest to 0.1.
      if (away < 1 - 1e-6) {
        EXPECT_EQ(value, 1) << x;
      }
      if (away > 1 + 1e-6) {
        EXPECT_EQ(value, 0) << x;
      }
    }
  }
}

// A blade of 1/20 pixel that begins 1/500 pixel beside the centres of column 20: no lattice of 4
// has a point on it, and a rasteriser that snaps to 1/256 may have it cover the centres.
TEST(EdgeMask, marks_a_blade_thinner_than_the_lattice_that_passes_beside_a_pixel_centre) {
  scene::Scene scene;
  const double x = 20.5 * 0.1 - 2;
  scene.objects = {floor_object(), slab(1, {x + 0.0002, -9}, {x + 0.005, 9})};
  scene::Camera camera = above(4);
  camera.near = 999.5;
  const auto mask = Tracer(scene).edge_mask(camera, {.position = {0, 1, 0, 0}}, 40, 40);
  for (int y = 0; y < 40; ++y) {
    EXPECT_EQ(mask.values[static_cast<std::size_t>(y * 40 + 20)], 1);
    EXPECT_EQ(mask.values[static_cast<std::size_t>(y * 40 + 22)], 0);
  }
}

TEST(EdgeMask, marks_outlines_and_not_the_creases_of_a_lit_solid) {
  scene::Scene scene;
  scene.objects = {object(scene::sphere(1, 24, 13), Role::both)};
  const Tracer tracer(scene);
  const scene::Camera camera{.eye = {0, 0.2, 4}, .target = {0, 0, 0}};
  const image::FloatImage mask = tracer.edge_mask(camera, point_light({0, 0.2, 4}), 64, 64);
  const SurfaceImage seen = tracer.surfaces(camera, 64, 64);
  for (int y = 1; y < 63; ++y) {
    for (int x = 1; x < 63; ++x) {
      const bool outline = seen.at(x, y).hit() != seen.at(x + 1, y).hit();
      if (outline) {
        EXPECT_EQ(mask.values[static_cast<std::size_t>(y * 64 + x)], 1);
      }
      bool inside = true;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) inside = inside && seen.at(x + i, y + j).hit();
      }
      if (inside && glm::length(glm::dvec2(x - 31.5, y - 31.5)) < 15) {
        EXPECT_EQ(mask.values[static_cast<std::size_t>(y * 64 + x)], 0) << x << " " << y;
      }
    }
  }
}

TEST(Comparison, counts_what_is_wrong_and_where) {
  const image::FloatImage truth{2, 2, {1, 1, 0, 0}}, mask{2, 2, {0, 1, 0, 0}};
  const Comparison same = compare(truth, truth, mask);
  EXPECT_EQ(same.wrong, 0u);
  EXPECT_EQ(same.rmse, 0);
  const Comparison off = compare({2, 2, {1, 0, 1, NAN}}, truth, mask);
  EXPECT_EQ(off.pixels, 4u);
  EXPECT_EQ(off.wrong, 3u);
  EXPECT_EQ(off.wrong_beyond_edge, 2u);
  EXPECT_EQ(off.edge_pixels, 1u);
  EXPECT_DOUBLE_EQ(off.rmse, std::sqrt(3.0 / 4));
  EXPECT_THROW(compare({1, 1, {1}}, truth, mask), InputError);
}

}  // namespace
}  // namespace shadowlab::truth
