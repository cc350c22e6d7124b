#include "shadow/plan.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "cities.h"

namespace shadowlab::shadow {
namespace {

constexpr glm::ivec2 picture{200, 100};

/// Looks along -z from the origin, 90 degrees high.
scene::Camera camera() {
  scene::Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  camera.fovy = 90;
  camera.near = 0.1;
  return camera;
}

/// A wall across the view at z = -10, and one caster.
scene::Scene wall_and(glm::dvec3 caster) {
  scene::Scene scene;
  scene.objects = {box_at({0, 0, -10}, {60, 60, 0.1}), box_at(caster, {1, 1, 1})};
  scene.objects[0].role = scene::Role::receiver;
  return scene;
}

TEST(Plan, keeps_a_caster_behind_the_camera_whose_shadow_is_seen) {
  const Plan found = plan(wall_and({0, 0, 5}), camera(), {0, 0, 1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_EQ(found.casters[0].object, 1u);
  EXPECT_FALSE(found.casters[0].apart) << "the camera stands in its shadow: z-fail";
  EXPECT_EQ(found.seen, std::vector<std::size_t>{0});
}

TEST(Plan, drops_a_caster_whose_shadow_stays_outside_the_view) {
  const Plan found = plan(wall_and({0, 0, 5}), camera(), {0, 0, -1, 0}, picture);
  ASSERT_EQ(found.dropped.size(), 1u);
  EXPECT_EQ(found.dropped[0].why, Plan::Why::outside_view);
}

TEST(Plan, drops_a_caster_whose_shadow_passes_through_the_view_and_meets_nothing) {
  // From above the view down through it at z = -5, before the wall.
  const Plan found = plan(wall_and({0, 20, -5}), camera(), {0, 1, 0, 0}, picture);
  ASSERT_EQ(found.dropped.size(), 1u);
  EXPECT_EQ(found.dropped[0].why, Plan::Why::meets_nothing);
  EXPECT_EQ(found.shadows.area(), 0);
  EXPECT_TRUE(found.shadowed.empty());
}

TEST(Plan, keeps_what_casts_on_itself_alone) {
  scene::Scene scene = wall_and({0, 0, -5});
  const Plan found = plan(scene, camera(), {0, 0, -1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_EQ(found.shadowed, std::vector<std::size_t>{1});
}

// The caster is 1 wide at depths 4.5 to 5.5: its near face reaches 0.5/4.5 of the half height of 50
// pixels from the middle, 5.6 pixels: 94.4 to 105.6 across, and 44.4 to 55.6 up. One pixel around
// for rounding; what boxes grow by is 1/32 of a pixel.
TEST(Plan, scissors_the_pixels_that_the_shadow_covers) {
  const Plan found = plan(wall_and({0, 0, -5}), camera(), {0, 0, -1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_EQ(found.casters[0].scissor, (PixelRectangle{93, 43, 14, 14}));
  EXPECT_EQ(found.shadows, found.casters[0].scissor);
}

// What a dropped caster would have covered: down through the view at z = -5, from x = -0.5 to 0.5
// and z = -5.5 to -4.5: 0.5/4.5 of 50 pixels from the middle, over the whole height.
TEST(Plan, tells_what_a_dropped_volume_would_cover) {
  const Plan found = plan(wall_and({0, 20, -5}), camera(), {0, 1, 0, 0}, picture);
  EXPECT_EQ(found.dropped.at(0).covered, (PixelRectangle{93, 0, 14, 100}));
}

TEST(Plan, of_a_scene_behind_the_camera_needs_nothing) {
  scene::Camera away = camera();
  away.target = {0, 0, 1};
  const Plan found = plan(wall_and({0, 0, -5}), away, {0, 0, -1, 0}, picture);
  EXPECT_TRUE(found.seen.empty());
  EXPECT_TRUE(found.casters.empty());
}

TEST(Plan, leaves_out_nothing_that_shadows_a_point_which_is_seen) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  int shadowed = 0, dropped = 0;
  for (int i = 0; i < 300; ++i) {
    const City city = random_city(random);
    const Plan found = plan(city.scene, city.camera, city.light, picture);
    dropped += static_cast<int>(found.dropped.size());
    const glm::dmat4 to_clip = city.camera.projection(2) * city.camera.view();
    for (int k = 0; k < 400; ++k) {
      const std::size_t at = random() % city.scene.objects.size();
      const glm::dvec4 p =
          city.scene.objects[at].model * glm::dvec4(unit(random), unit(random), unit(random), 1);
      const glm::dvec4 clip = to_clip * p;
      if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || clip.z < -clip.w) continue;
      const bool hidden = std::ranges::any_of(city.scene.objects, [&](const auto& object) {
        return meets(object, p, glm::dvec4(city.camera.eye, 1)) &&
               &object != &city.scene.objects[at];
      });
      if (hidden) continue;
      EXPECT_TRUE(std::ranges::count(found.seen, at));
      for (const auto& out : found.dropped)
        EXPECT_FALSE(meets(city.scene.objects[out.object], p, city.light));
      for (const auto& kept : found.casters) {
        if (!meets(city.scene.objects[kept.object], p, city.light)) continue;
        const double x = (clip.x / clip.w + 1) * 100, y = (clip.y / clip.w + 1) * 50;
        const PixelRectangle& s = kept.scissor;
        EXPECT_TRUE(x >= s.x && x <= s.x + s.width && y >= s.y && y <= s.y + s.height);
        EXPECT_TRUE(std::ranges::count(found.shadowed, at));
        ++shadowed;
      }
    }
  }
  EXPECT_GT(shadowed, 1000);
  EXPECT_GT(dropped, 300);
}

}  // namespace
}  // namespace shadowlab::shadow
