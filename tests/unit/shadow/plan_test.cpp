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

// Lit from behind, a little from above and aside: its near face alone is seen, and dark. Of itself
// it shadows that face, which is known without a volume; and its shadow, toward the camera, meets
// nothing.
TEST(Plan, needs_no_volume_of_a_box_that_shadows_its_own_far_sides_alone) {
  const Plan found = plan(wall_and({0, 0, -5}), camera(), {0.1, 0.2, -1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_EQ(found.casters[0].scissor.area(), 0);
  EXPECT_TRUE(found.casters[0].unlit);
  EXPECT_EQ(found.shadowed, std::vector<std::size_t>{1});
  EXPECT_EQ(found.shadows, (PixelRectangle{93, 43, 14, 14})) << "where the box is seen";
}

TEST(Plan, drops_a_box_of_which_lit_sides_alone_are_seen_and_whose_shadow_meets_nothing) {
  scene::Scene scene = wall_and({0, 0, -5});
  scene.objects.erase(scene.objects.begin());
  const Plan found = plan(scene, camera(), {0.1, 0.2, 1, 0}, picture);
  ASSERT_EQ(found.dropped.size(), 1u);
  EXPECT_EQ(found.dropped[0].why, Plan::Why::all_lit);
  EXPECT_TRUE(found.shadowed.empty());
  EXPECT_EQ(found.seen, std::vector<std::size_t>{0});
}

// The light runs along four of its sides: how they are turned is not told from rounding, so that
// the volume is kept.
TEST(Plan, keeps_the_volume_of_a_box_whose_sides_the_light_grazes) {
  scene::Scene scene = wall_and({0, 0, -5});
  scene.objects.erase(scene.objects.begin());
  const Plan found = plan(scene, camera(), {0, 0, 1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_EQ(found.casters[0].scissor, (PixelRectangle{93, 43, 14, 14}));
  EXPECT_TRUE(found.casters[0].unlit);
}

TEST(Plan, keeps_a_lit_box_for_what_it_shadows_and_not_for_itself) {
  const Plan found = plan(wall_and({0, 0, -5}), camera(), {0.4, 0.2, 1, 0}, picture);
  ASSERT_EQ(found.casters.size(), 1u);
  EXPECT_GT(found.casters[0].scissor.area(), 0);
  EXPECT_FALSE(found.casters[0].unlit);
  EXPECT_EQ(found.shadowed, std::vector<std::size_t>{0});
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

struct Spot {
  std::size_t object;
  glm::dvec3 place, outward;  ///< world space
};
Spot random_spot(std::mt19937& random, const scene::Scene& scene) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  const std::size_t object = random() % scene.objects.size();
  const auto axis = static_cast<glm::length_t>(random() % 3);
  glm::dvec3 on_box(unit(random), unit(random), unit(random)), outward(0);
  outward[axis] = random() % 2 ? 1 : -1;
  on_box[axis] = outward[axis] / 2;
  const glm::dmat4& model = scene.objects[object].model;  // stretches along axes
  return {object, glm::dvec3(model * glm::dvec4(on_box, 1)), outward};
}

// Spots of boxes that the camera sees. What is in the shadow of another box has a volume that is
// counted there; what is turned from the light belongs to a box that is marked, or counted.
TEST(Plan, leaves_out_nothing_that_shadows_a_point_which_is_seen) {
  std::mt19937 random(3);
  int shadowed = 0, unlit = 0, dropped = 0, without = 0;
  for (int i = 0; i < 300; ++i) {
    const City city = random_city(random);
    const auto& objects = city.scene.objects;
    const Plan found = plan(city.scene, city.camera, city.light, picture);
    dropped += static_cast<int>(found.dropped.size());
    const glm::dmat4 to_clip = city.camera.projection(2) * city.camera.view();
    for (int k = 0; k < 1600; ++k) {
      const auto [at, p, outward] = random_spot(random, city.scene);
      const glm::dvec4 clip = to_clip * glm::dvec4(p, 1);
      if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || clip.z < -clip.w) continue;
      if (glm::dot(outward, city.camera.eye - p) <= 0) continue;
      const bool hidden = std::ranges::any_of(objects, [&](const auto& object) {
        return &object != &objects[at] && meets(object, p, glm::dvec4(city.camera.eye, 1));
      });
      if (hidden) continue;
      EXPECT_TRUE(std::ranges::count(found.seen, at));
      const bool dark = glm::dot(outward, glm::dvec3(city.light) - city.light.w * p) < 0;
      const auto shadows = [&](std::size_t object) {
        return object == at ? dark : meets(objects[object], p, city.light);
      };
      for (const auto& out : found.dropped) EXPECT_FALSE(shadows(out.object));
      for (const auto& kept : found.casters) {
        if (!shadows(kept.object)) continue;
        EXPECT_TRUE(std::ranges::count(found.shadowed, at));
        const double x = (clip.x / clip.w + 1) * 100, y = (clip.y / clip.w + 1) * 50;
        const auto holds = [&](const PixelRectangle& s) {
          return x >= s.x && x <= s.x + s.width && y >= s.y && y <= s.y + s.height;
        };
        EXPECT_TRUE(holds(found.shadows));
        if (kept.object == at) {
          EXPECT_TRUE(kept.unlit);
          ++unlit;
          without += kept.scissor.area() == 0;
        } else {
          EXPECT_TRUE(holds(kept.scissor));
          ++shadowed;
        }
      }
    }
  }
  EXPECT_GT(shadowed, 300);
  EXPECT_GT(unlit, 1000);
  EXPECT_GT(without, 100);
  EXPECT_GT(dropped, 300);
}

}  // namespace
}  // namespace shadowlab::shadow
