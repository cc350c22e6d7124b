#include "measure/limit.h"

#include <gtest/gtest.h>

#include <memory>

namespace shadowlab::measure {
namespace {

// A card of two by two, one metre above a floor that is seen from straight above the card's edge.
class LimitsTest : public testing::Test {
 protected:
  LimitsTest() {
    add(scene::plane(20, 20), glm::dmat4(1), scene::Role::receiver);
    glm::dmat4 up(1);
    up[3].y = 1;
    add(scene::plane(2, 2), up, scene::Role::caster);
    scene.camera = {.eye = {1.5, 4, 0}, .target = {1.5, 0, 0}, .up = {1, 0, 0}, .near = 0.1};
    scene.lights.assign(1, {.position = {0, 5, 0, 1}});
    tracer = std::make_unique<truth::Tracer>(scene);
  }

  void add(const scene::Mesh& mesh, const glm::dmat4& model, scene::Role role) {
    scene.objects.emplace_back();
    scene.objects.back().mesh = std::make_shared<scene::Mesh>(mesh);
    scene.objects.back().model = model;
    scene.objects.back().role = role;
  }

  // The floor at (x, 0, 0). The card's shadow ends at x = 1.25.
  truth::Surface floor_at(double x) const {
    truth::Surface surface;
    surface.object = 0;
    surface.triangle = 0;
    surface.point = {x, 0, 0};
    surface.depth = 4;
    surface.normal = {0, 1, 0};
    return surface;
  }
  bool allowed(const recipe::Limit& limit, double x, bool lit) const {
    return Limits(scene, *tracer, limit, 64).allow(floor_at(x), lit);
  }

  scene::Scene scene;
  std::unique_ptr<truth::Tracer> tracer;
};

TEST_F(LimitsTest, of_nothing_allow_nothing_but_what_a_rasterizer_s_corners_may_move) {
  EXPECT_FALSE(allowed({}, 1.2, true));
  EXPECT_FALSE(allowed({}, 1.3, false));
  EXPECT_TRUE(allowed({}, 1.25 + 1e-5, false)) << "1/128 of a pixel is 4e-4 m";
}

TEST_F(LimitsTest, across_the_light_reach_as_far_as_the_texels) {
  // The card's edge is 1.2 / 1.25 of the way out to (1.2, 0, 0): 0.04 m at 4.1 m from the light.
  EXPECT_FALSE(allowed({.across = 0.009}, 1.2, true));
  EXPECT_TRUE(allowed({.across = 0.010}, 1.2, true));
  EXPECT_TRUE(allowed({.across = 0.010}, 1.3, false));
}

TEST_F(LimitsTest, along_the_sight_reach_as_far_as_the_depth_buffer_s_steps) {
  // From the floor 4 m away a ray to the eye leaves the card's shadow where it is above x = 1.25.
  scene.camera.eye = {5.25, 3, 0};
  scene.camera.target = {1.2, 0, 0};
  const double step = 25 / (0.1 * 0x1p24);  // z² / (near 2^24), z near 5
  EXPECT_FALSE(allowed({.eye_units = 1e-3 / step}, 1.2, true));
  EXPECT_TRUE(allowed({.eye_units = 0.2 / step}, 1.2, true));
  EXPECT_TRUE(allowed({.eye_units = 0.2 / step}, 1.3, false)) << "and away from it";
}

TEST_F(LimitsTest, toward_the_light_reach_as_far_as_the_map_s_depths) {
  // The card is one metre before the floor, five from the light.
  const double step = 25 / (1 * 0x1p24);
  EXPECT_FALSE(allowed({.light_units = 0.9 / step, .light_near = 1}, 0.5, true));
  EXPECT_TRUE(allowed({.light_units = 1.2 / step, .light_near = 1}, 0.5, true));
}

}  // namespace
}  // namespace shadowlab::measure
