#include "measure/limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

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

// A second card beside the first. Over the floor at x = 1.2 the ray to the eye meets the plane of
// light at its edge, x0 at a height of 1, where 1.2 + .804 s = (5 - .595 s) x0 / 4.
class LimitsOfTwoCards : public LimitsTest {
 protected:
  explicit LimitsOfTwoCards() {
    scene.camera.eye = {5.25, 3, 0};
    scene.camera.target = {1.2, 0, 0};
  }
  void add_card_from(double x0) {
    glm::dmat4 beside(1);
    beside[3] = {x0 + 1, 1, 0, 1};
    add(scene::plane(2, 2), beside, scene::Role::caster);
    tracer = std::make_unique<truth::Tracer>(scene);
  }
  // z² / (near 2^24) of the view's depth 4, along a sight that is 5.04 long.
  const double step = 4 * 5.04 / (0.1 * 0x1p24);
};

TEST_F(LimitsOfTwoCards, along_the_sight_meet_a_strip_of_light_however_narrow) {
  add_card_from(1.002);  // lit from s = .0525 to .0551
  EXPECT_FALSE(allowed({.eye_units = 0.052 / step}, 1.2, true));
  EXPECT_TRUE(allowed({.eye_units = 0.054 / step}, 1.2, true));
}

TEST_F(LimitsOfTwoCards, may_take_one_of_two_sides_and_not_the_other) {
  add_card_from(
      0.976);  // its shadow begins at s = .0211, before the first ends at .0525: all is dark
  EXPECT_FALSE(allowed({.eye_units = 0.04 / step}, 1.2, true));
  EXPECT_TRUE(allowed({.eye_units = 0.06 / step}, 1.2, true));
}

// A light on the card lights what is below or does not, by less than 2^-17 of the card's radius:
// what a light below it lights. A world's coordinates may be so long that a surface's place is
// rounded by more than a ray's own error.
TEST_F(LimitsTest, of_a_light_on_a_sheet_are_the_same_a_million_units_away) {
  glm::dmat4 below(1);
  below[3] = {0.3, 0, 0, 1};
  add(scene::box({3, 0.5, 3}), below, scene::Role::caster);
  for (const double away : {0.0, 775053.0}) {
    // Turned, so that no coordinate is exact.
    glm::dmat4 world = glm::translate(glm::dmat4(1), {-away, 0.01 * away, 0.6 * away});
    world = glm::rotate(world, 0.7, {1, 2, 3});
    const auto placed = [&](double x, double y, double z) {
      return glm::dvec3(world * glm::dvec4(x, y, z, 1));
    };
    scene::Scene there = scene;
    for (scene::Object& object : there.objects) object.model = world * object.model;
    there.camera.eye = placed(5.3, 3.1, 0.7);
    there.camera.target = placed(0, 0, 0);
    there.camera.up = {0, 1, 0};
    const auto light_at = [&](double height) {
      return scene::Light{.position = glm::dvec4(placed(0.1, height, 0.2), 1)};
    };
    there.lights[0] = light_at(1 + 1e-7);
    const truth::Tracer traced(there);
    const Limits limits(there, traced, {}, 24);
    const auto seen = traced.surfaces(there.camera, 24, 24);
    const auto above = traced.visibility(there.camera, there.lights[0], 24, 24);
    const auto under = traced.visibility(there.camera, light_at(1 - 1e-7), 24, 24);
    int lit_from_below = 0;
    for (std::size_t i = 0; i < seen.surfaces.size(); ++i) {
      if (seen.surfaces[i].object != 2 || above.values[i] == under.values[i]) continue;
      EXPECT_TRUE(limits.allow(seen.surfaces[i], true)) << away << ", pixel " << i;
      ++lit_from_below;
    }
    EXPECT_GT(lit_from_below, 50);
  }
}

// In the plane through the light and the card's edge at x = 1 the eye sees that side of the card's
// volume edge on; from there the sight at a height of .5 passes both its ends, at z = ±1.125.
TEST_F(LimitsTest, may_take_a_side_that_is_seen_edge_on_for_before_or_behind) {
  truth::Surface surface = floor_at(0);
  surface.point = {1.125, 0.5, 4};
  surface.normal = {0, 0, -1};
  const auto dark_seen_from = [&](double x) {
    scene.camera.eye = {x, 0.5, -5};
    return Limits(scene, *tracer, {.eye_units = 1e-3}, 64).allow(surface, false);
  };
  EXPECT_TRUE(dark_seen_from(1.125));
  EXPECT_FALSE(dark_seen_from(1.13)) << "1/128 of a pixel is 4e-4 m";
}

// The card's shadow ends at x = 1.25. A post that stands in the floor has a foot, which is no edge.
TEST_F(LimitsTest, on_the_receiver_reach_as_far_as_its_texture_s_filter) {
  EXPECT_FALSE(allowed({.on_receiver = 0.045}, 1.2, true));
  EXPECT_TRUE(allowed({.on_receiver = 0.055}, 1.2, true));
  glm::dmat4 stands(1);
  stands[3] = {4, 0, 0, 1};
  add(scene::box({1, 2, 1}), stands, scene::Role::caster);
  tracer = std::make_unique<truth::Tracer>(scene);
  EXPECT_FALSE(allowed({.on_receiver = 0.045}, 3.45, false));
  EXPECT_TRUE(allowed({.on_receiver = 0.055}, 3.45, false));
}

TEST_F(LimitsTest, toward_the_light_reach_as_far_as_the_map_s_depths) {
  // The card is one metre before the floor, five from the light.
  const double step = 25 / (1 * 0x1p24);
  EXPECT_FALSE(allowed({.light_units = 0.9 / step, .light_near = 1}, 0.5, true));
  EXPECT_TRUE(allowed({.light_units = 1.2 / step, .light_near = 1}, 0.5, true));
  EXPECT_FALSE(allowed({.light_units = 1.2 / step, .light_near = 1}, 1.5, false)) << "lit";
  EXPECT_TRUE(allowed({.light_units = HUGE_VAL, .light_near = 1}, 1.5, false)) << "tells no depths";
}

}  // namespace
}  // namespace shadowlab::measure
