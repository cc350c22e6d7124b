#include "shadow/zfail.h"

#include <random>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shadow/infinite_perspective.h"

namespace shadowlab::shadow {
namespace {

using scene::Bounds;
using scene::Camera;

/// Whether the segment (or ray, for w = 0) from p to the light meets the box; by slabs.
bool meets(glm::dvec3 p, glm::dvec4 light, const Bounds& box) {
  const glm::dvec3 way = light.w == 0 ? glm::dvec3(light) : glm::dvec3(light) / light.w - p;
  double in = 0, out = light.w == 0 ? 1e300 : 1;
  for (int i = 0; i < 3; ++i) {
    if (way[i] == 0 && (p[i] < box.low[i] || p[i] > box.high[i])) return false;
    if (way[i] == 0) continue;
    const double a = (box.low[i] - p[i]) / way[i], b = (box.high[i] - p[i]) / way[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out;
}

struct Setting {
  Camera camera;
  double aspect = 1;
  glm::dvec4 light{0};
  Bounds box;
  glm::dmat4 model{1.0};
};

Setting random_setting(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  Setting s;
  s.camera.eye = point();
  s.camera.target = point();
  s.camera.up = point();
  s.camera.fovy = 20 + 120 * unit(random);
  s.camera.near = std::pow(10, 2 * unit(random) - 2);
  s.aspect = 0.3 + 2 * unit(random);
  s.light = {point() * 1.5, random() % 3 == 0 ? 0.0 : 1.0};
  // Sometimes in the near plane itself, where the pyramid is flat.
  if (random() % 8 == 0) {
    const auto corners = near_rectangle(s.camera, s.aspect);
    s.light = {
        corners[0] + (corners[1] - corners[0]) * 3.0 + (corners[3] - corners[0]) * normal(random),
        1};
  }
  const glm::dvec3 center = point() * 1.5, half = glm::abs(point()) * 0.8;
  s.box = {center - half, center + half};
  return s;
}

/// A point of the near rectangle.
glm::dvec3 on_near(const std::array<glm::dvec3, 4>& corners, double u, double v) {
  return corners[0] + (corners[1] - corners[0]) * u + (corners[3] - corners[0]) * v;
}

TEST(NeedsZfail, is_true_whenever_a_way_from_the_near_rectangle_to_the_light_meets_the_box) {
  std::mt19937 random(1);
  int met = 0, needless = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Setting s = random_setting(random);
    const auto corners = near_rectangle(s.camera, s.aspect);
    const bool needs = needs_zfail(s.camera, s.aspect, s.light, s.box);
    bool meets_one = false;
    for (int i = 0; i <= 40 && !meets_one; ++i) {
      for (int j = 0; j <= 40 && !meets_one; ++j) {
        meets_one = meets(on_near(corners, i / 40.0, j / 40.0), s.light, s.box);
      }
    }
    ASSERT_TRUE(needs || !meets_one) << "trial " << trial;
    met += meets_one ? 1 : 0;
    needless += needs && !meets_one ? 1 : 0;
  }
  // Both answers occur; only ways between the 41² samples may make it true without a witness.
  EXPECT_GT(met, 2000);
  EXPECT_LT(met, 18000);

  EXPECT_LT(needless, met / 200);
}

TEST(NeedsZfail, moves_with_the_world) {
  // A rotated and stretched object is the same as its box in its own space.
  std::mt19937 random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    Setting s = random_setting(random);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) s.model[i][j] = normal(random);
    }
    s.model[3] = {normal(random), normal(random), normal(random), 1};
    const glm::dmat4 to_model = glm::inverse(s.model);
    const bool needs = needs_zfail(s.camera, s.aspect, s.light, s.box, s.model);
    const auto corners = near_rectangle(s.camera, s.aspect);
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10; ++j) {
        const glm::dvec4 p = to_model * glm::dvec4(on_near(corners, i / 10.0, j / 10.0), 1);
        ASSERT_TRUE(needs || !meets(p, to_model * s.light, s.box)) << "trial " << trial;
      }
    }
  }
}

TEST(NeedsZfail, tells_where_the_caster_is_on_the_way) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  const Bounds behind{{-1, -1, 4}, {1, 1, 6}}, before{{-1, -1, -6}, {1, 1, -4}};
  EXPECT_TRUE(needs_zfail(camera, 1, {0, 0, 10, 1}, behind));
  EXPECT_TRUE(needs_zfail(camera, 1, {0, 0, 1, 0}, behind));
  EXPECT_FALSE(needs_zfail(camera, 1, {0, 0, 2, 1}, behind));
  EXPECT_FALSE(needs_zfail(camera, 1, {0, 0, 10, 1}, before));
  EXPECT_TRUE(needs_zfail(camera, 1, {0, 0, -10, 1}, before));
  EXPECT_FALSE(needs_zfail(camera, 1, {0, 0, 1, 0}, before));
  // Around the near plane, and nothing at all.
  EXPECT_TRUE(needs_zfail(camera, 1, {5, 5, 5, 1}, {{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_FALSE(needs_zfail(camera, 1, {5, 5, 5, 1}, Bounds{}));
  EXPECT_THROW(needs_zfail(camera, 1, {0, 0, 0, 0}, behind), InputError);
  EXPECT_THROW(needs_zfail(camera, 1, {0, 0, 1, 0}, behind, glm::dmat4(0.0)), InputError);
}

TEST(InfinitePerspective, is_the_limit_of_the_finite_one) {
  Camera camera;
  camera.fovy = 60;
  camera.near = 0.25;
  camera.far = 1e12;
  const glm::dmat4 infinite = infinite_perspective(60, 1.5, 0.25), finite = camera.projection(1.5);
  for (int i = 0; i < 4; ++i) {
    // (far + near) / (far - near) differs from 1 by 2 near / far.
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(infinite[i][j], finite[i][j], 1e-12);
  }
}

TEST(InfinitePerspective, puts_directions_on_the_far_plane_exactly_even_in_float) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (int trial = 0; trial < 1000; ++trial) {
    Camera camera;
    camera.eye = {normal(random) * 100, normal(random), normal(random)};
    const glm::mat4 matrix(infinite_perspective(50, 1.3, 0.1) * camera.view());
    const glm::vec4 clip = matrix * glm::vec4(normal(random), normal(random), normal(random), 0);
    ASSERT_EQ(clip.z, clip.w);
  }
}

TEST(InfinitePerspective, refuses_what_is_no_projection) {
  EXPECT_THROW(infinite_perspective(0, 1, 1), InputError);
  EXPECT_THROW(infinite_perspective(180, 1, 1), InputError);
  EXPECT_THROW(infinite_perspective(60, 0, 1), InputError);
  EXPECT_THROW(infinite_perspective(60, 1, 0), InputError);
  EXPECT_THROW(infinite_perspective(60, 1, std::nan("")), InputError);
}

TEST(NeedsZfail, says_how_far_the_caster_is_from_the_pyramid_in_world_space) {
  Camera camera;
  camera.eye = {0, 0, 5};
  camera.target = {0, 0, 0};
  camera.near = 1;
  const Bounds box{{-1, -1, -1}, {1, 1, 1}};
  const glm::dvec4 light(0, 0, 8, 1);  // behind the camera: the pyramid is over z = 4
  // Twice as large, and turned so that the world's z is the model's x; 4 - 2 = 2 apart, less the
  // margin of 1e-6 of the coordinates.
  const glm::dmat4 model(0, 0, 2, 0, 0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 0, 1);
  const auto apart = apart_from_near_pyramid(camera, 1, light, box, model);
  ASSERT_TRUE(apart);
  EXPECT_NEAR(apart->gap, 2, 1e-5);
  EXPECT_NEAR(std::abs(apart->direction.z), 1, 1e-12);
}

}  // namespace
}  // namespace shadowlab::shadow
