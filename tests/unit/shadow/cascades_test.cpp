// Splits and cascades, and the bias of a map.
#include "shadow/cascades.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "shadow/map_bias.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

TEST(Splits, of_lambda_0_are_uniform_and_of_lambda_1_logarithmic) {
  EXPECT_EQ(split_distances(1, 9, 4, 0), (std::vector<double>{1, 3, 5, 7, 9}));
  const auto logarithmic = split_distances(1, 16, 4, 1);
  for (std::size_t i = 0; i <= 4; ++i)
    EXPECT_NEAR(logarithmic[i], std::pow(2.0, i), 1e-14);  // pow, rounded
  const auto half = split_distances(1, 16, 4, 0.5);
  for (std::size_t i = 0; i <= 4; ++i)
    EXPECT_NEAR(half[i], (std::pow(2.0, i) + 1 + 3.75 * static_cast<double>(i)) / 2, 1e-14);
}

TEST(Splits, of_near_far_a_million_are_finite_and_grow) {
  for (const double lambda : {0.0, 0.5, 1.0}) {
    const auto z = split_distances(1e-3, 1e3, 8, lambda);
    EXPECT_EQ(z.front(), 1e-3);
    EXPECT_EQ(z.back(), 1e3);
    for (std::size_t i = 1; i < z.size(); ++i) {
      EXPECT_TRUE(std::isfinite(z[i]));
      EXPECT_GT(z[i], z[i - 1]);
      // (10^6)^(1/8) from each to the next.
      if (lambda == 1) {
        EXPECT_NEAR(z[i] / z[i - 1], std::pow(10.0, 0.75), 1e-13);
      }
    }
  }
}

TEST(Splits, refuse_what_is_none) {
  EXPECT_THROW(split_distances(0, 1, 4, 0.5), InputError);
  EXPECT_THROW(split_distances(2, 1, 4, 0.5), InputError);
  EXPECT_THROW(split_distances(1, 2, 0, 0.5), InputError);
  EXPECT_THROW(split_distances(1, 2, 4, 1.5), InputError);
  EXPECT_THROW(split_distances(1, INFINITY, 4, 0.5), InputError);
}

scene::Scene boxes() {
  scene::Scene scene;
  for (int i = 0; i < 5; ++i) {
    scene::Object object;
    object.mesh = std::make_shared<const scene::Mesh>(scene::box(dvec3(1, 2, 1)));
    object.model[3] = dvec4(2.0 * i - 4, 1, -8.0 * i, 1);
    scene.objects.push_back(object);
  }
  scene.camera = {{0, 3, 6}, {0, 1, 0}, {0, 1, 0}, 50, 0.5, 60};
  return scene;
}

std::vector<Cascade> cascades_of(const scene::Scene& scene, CascadeOptions::Fit fit) {
  return cascades(scene, scene.camera, 1.5, {1, 2, 0.5, 0}, 4,
                  {scene.camera.near, scene.camera.far}, {0.7, fit, 512});
}

// Stable maps: their matrices differ by whole texels (2/512 of clip space) in x and y alone,
// whatever the camera does.
TEST(Cascades, that_are_stable_move_in_whole_texels) {
  auto scene = boxes();
  const auto before = cascades_of(scene, CascadeOptions::Fit::stable);
  int moved = 0;
  for (int step = 1; step <= 50; ++step) {
    scene.camera.eye += dvec3(0.013, 0.002, -0.031);
    scene.camera.target += dvec3(0.03, -0.01, -0.02);
    const auto after = cascades_of(scene, CascadeOptions::Fit::stable);
    for (std::size_t i = 0; i < 4; ++i) {
      const dmat4 a = before[i].light.projection * before[i].light.view,
                  b = after[i].light.projection * after[i].light.view;
      for (int column = 0; column < 3; ++column) EXPECT_EQ(a[column], b[column]);
      const dvec4 shift = (b[3] - a[3]) * 256.0;
      EXPECT_EQ(shift.z, 0);
      // Sums of order one, rounded: 256 · 2^-53 times a few.
      EXPECT_NEAR(shift.x, std::round(shift.x), 1e-12);
      EXPECT_NEAR(shift.y, std::round(shift.y), 1e-12);
      moved += std::abs(shift.x) > 0.5;
    }
  }
  EXPECT_GT(moved, 20);
}

// Each part of the view is inside of its own map.
TEST(Cascades, that_are_stable_hold_their_part_of_the_view) {
  auto scene = boxes();
  for (int step = 0; step < 20; ++step) {
    scene.camera.eye += dvec3(0.37, 0.02, -0.31);
    scene.camera.target += dvec3(-0.3, 0.05, 0.2);
    for (const auto fit : {CascadeOptions::Fit::stable, CascadeOptions::Fit::camera}) {
      for (const Cascade& cascade : cascades_of(scene, fit)) {
        for (const dvec3& corner : frustum(scene.camera, 1.5, cascade.near, cascade.far).corners) {
          const dvec4 p = cascade.light.projection * cascade.light.view * dvec4(corner, 1);
          EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1 + 1e-12);  // rounding
        }
      }
    }
  }
}

TEST(Cascades, have_the_splits_that_their_lambda_gives) {
  const auto scene = boxes();
  const auto z = split_distances(0.5, 60, 4, 0.7);
  for (const auto fit : {CascadeOptions::Fit::tight, CascadeOptions::Fit::stable}) {
    const auto found = cascades_of(scene, fit);
    ASSERT_EQ(found.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(found[i].near, z[i]);
      EXPECT_EQ(found[i].far, z[i + 1]);
    }
  }
}

TEST(Cascades, that_are_stable_refuse_a_point_light) {
  const auto scene = boxes();
  EXPECT_THROW(cascades(scene, scene.camera, 1, {0, 9, 0, 1}, 2, {1, 9},
                        {0.5, CascadeOptions::Fit::stable, 512}),
               InputError);
}

TEST(DepthPresent, is_from_the_nearest_to_the_farthest_that_is_seen) {
  scene::Scene scene;
  scene.objects.resize(1);
  scene.objects[0].mesh = std::make_shared<const scene::Mesh>(scene::box(dvec3(2)));
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 60, 0.1, 100};
  auto range = depth_present(scene, scene.camera, 1);
  EXPECT_NEAR(range.near, 9, 1e-14);
  EXPECT_NEAR(range.far, 11, 1e-14);
  scene.camera.eye = {0, 0, 0.5};  // inside of it
  scene.camera.target = {0, 0, -5};
  range = depth_present(scene, scene.camera, 1);
  EXPECT_EQ(range.near, 0.1);
  EXPECT_NEAR(range.far, 1.5, 1e-14);
  scene.camera.target = {0, 0, 50};
  scene.camera.eye = {0, 0, 10};  // away from it
  range = depth_present(scene, scene.camera, 1);
  EXPECT_EQ(range.near, 0.1);
  EXPECT_EQ(range.far, 100);
}

// A plane sampled half a filter off in both directions is never farther than the offset along its
// normal, nor the depth's change larger than factor · m.
TEST(MapBias, covers_a_plane_over_the_filters_reach_and_no_more_than_needed) {
  dmat4 projection(1);
  projection[0][0] = projection[1][1] = 0.25;  // a window of 8 metres
  for (const double filter : {1.0, 2.0, 5.0}) {
    const MapBias bias = map_bias(projection, 512, filter);
    EXPECT_EQ(bias.texel, 8.0 / 512);
    const double reach = filter / 2 * bias.texel;
    for (const double degrees : {0.0, 30.0, 60.0, 89.0, 89.9}) {
      for (const double turn : {0.0, 20.0, 45.0}) {
        const double slope = std::tan(glm::radians(degrees)), angle = glm::radians(turn);
        const double x = slope * std::cos(angle), y = slope * std::sin(angle);
        const double change = reach * (std::abs(x) + std::abs(y));
        const double m = std::max(std::abs(x), std::abs(y)) * bias.texel;
        EXPECT_LE(change, bias.factor * m);
        EXPECT_LE(change, 8 * bias.reach * (std::abs(x) + std::abs(y)));
        const double gained =
            bias.normal_offset * std::sin(glm::radians(degrees)) / std::cos(glm::radians(degrees));
        EXPECT_LE(change, gained + 1e-15);
        // At 45 degrees both are needed in full, but for the 1/64 texel of snapping.
        if (turn == 45 && degrees > 0) {
          EXPECT_GT(change, 0.96 * bias.factor * m);
          EXPECT_GT(change, 0.96 * gained);
        }
      }
    }
  }
  EXPECT_THROW(map_bias(projection, 0, 1), InputError);
  EXPECT_THROW(map_bias(projection, 512, 0.5), InputError);
}

// What a vertex shader's floats make of a depth, of either of the two that are compared: half the
// units, each 2^-24.
TEST(MapBias, covers_the_rounding_of_depths_from_however_far_a_light) {
  for (const double distance : {2.0, 1e2, 1e4, 1e6}) {
    const dmat4 projection = glm::perspective(2 / distance, 1.0, distance - 1, distance + 1);
    const double units = map_bias(projection, 512, 1).units;
    for (int i = 0; i <= 1000; ++i) {
      const auto z = static_cast<float>(-(distance - 1 + 2 * i / 1000.0));
      const double exact = -(projection[2][2] * double(z) + projection[3][2]) / double(z) / 2;
      const float drawn =
          -(static_cast<float>(projection[2][2]) * z + static_cast<float>(projection[3][2])) / z /
          2;
      ASSERT_LE(std::abs(double(drawn) - exact), units / 2 * 0x1p-24) << distance << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace shadowlab::shadow
