// How hands move cameras, lights and casters.
#include <gtest/gtest.h>

#include "live/dragging.h"
#include "live/orbit.h"

namespace shadowlab::live {
namespace {

constexpr double rounding = 1e-12;  // of some dozen operations on numbers of about 1 to 10

scene::Camera camera() {
  scene::Camera camera;
  camera.eye = {3, 2, 6};
  camera.target = {0.5, 0.25, -1};
  return camera;
}

TEST(Orbit, keeps_the_distance_and_a_turn_of_360_degrees_comes_back) {
  const scene::Camera before = camera();
  scene::Camera moved = before;
  for (int i = 0; i < 36; ++i) {
    moved = orbited(moved, 10, 0);
    EXPECT_NEAR(glm::length(moved.eye - moved.target), glm::length(before.eye - before.target),
                rounding);
    EXPECT_NEAR(moved.eye.y, before.eye.y, rounding);
  }
  EXPECT_LT(glm::length(moved.eye - before.eye), 1e-11);
}

TEST(Orbit, never_passes_above_or_below) {
  scene::Camera up = camera(), down = camera();
  for (int i = 0; i < 50; ++i) {
    up = orbited(up, 3, 20);
    down = orbited(down, 3, -20);
    EXPECT_NO_THROW(up.view());
    EXPECT_NO_THROW(down.view());
  }
  EXPECT_GT(up.eye.y, up.target.y);
  EXPECT_LT(down.eye.y, down.target.y);
}

TEST(Orbit, approaching_and_going_back_is_where_it_was) {
  const scene::Camera there = approached(approached(camera(), 0.5), 2);
  EXPECT_LT(glm::length(there.eye - camera().eye), rounding);
  EXPECT_EQ(approached(camera(), 0).target, camera().target) << "it never reaches the target";
  EXPECT_NO_THROW(approached(camera(), 0).view());
  EXPECT_GE(approached(camera(), 100).far, 100 * glm::length(camera().eye - camera().target));
}

TEST(Orbit, a_shift_of_half_a_picture_moves_the_middle_to_its_border) {
  const scene::Camera moved = shifted(camera(), 0, 0.5);
  const Seen place = seen(moved, 1.5, camera().target);
  EXPECT_NEAR(place.x, 0, rounding);
  EXPECT_NEAR(place.y, -1, rounding);
}

TEST(Orbit, a_ray_leads_through_what_is_seen_there) {
  for (const glm::dvec3 point :
       {glm::dvec3(0, 0, 0), glm::dvec3(1, -2, 0.5), glm::dvec3(-3, 1, 1)}) {
    const Seen place = seen(camera(), 1.25, point);
    const Ray ray = ray_through(camera(), 1.25, place.x, place.y);
    const glm::dvec3 arm = point - ray.origin;
    EXPECT_LT(glm::length(arm - ray.direction * glm::length(arm)), 1e-11);
  }
}

TEST(Dragging, a_light_is_the_light_of_its_handle) {
  for (const glm::dvec4 light : {glm::dvec4(2, 4, 1, 1), glm::dvec4(0, 0.6, 0.8, 0)}) {
    const glm::dvec3 handle = light_handle(light, camera());
    EXPECT_LT(glm::length(light_of_handle(handle, light, camera()) - light), rounding);
  }
}

TEST(Dragging, a_plane_is_met_before_the_eye_alone) {
  const Ray down{{0, 2, 0}, {0, -1, 0}};
  EXPECT_EQ(on_plane(down, {0, 0.5, 0}, {0, 1, 0}), glm::dvec3(0, 0.5, 0));
  EXPECT_FALSE(on_plane(down, {0, 3, 0}, {0, 1, 0}));
  EXPECT_FALSE(on_plane(down, {0, 0, 0}, {1, 0, 0}));
}

TEST(Dragging, what_is_taken_hold_of_is_the_first_caster_and_no_floor) {
  scene::Scene scene;
  const auto box = std::make_shared<scene::Mesh>(scene::box());
  const auto floor = std::make_shared<scene::Mesh>(scene::plane(10, 10));
  scene.objects.push_back({"floor", floor, glm::dmat4(1), {}, scene::Role::receiver});
  scene.objects.push_back({"box", box, glm::dmat4(1), {}, scene::Role::caster});
  const auto hit = first_caster(scene, {{0, 5, 0.1}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->object, 1u);
  EXPECT_NEAR(hit->point.y, 0.5, rounding);
  EXPECT_FALSE(first_caster(scene, {{3, 5, 0}, {0, -1, 0}})) << "the floor";
  EXPECT_FALSE(first_caster(scene, {{0, 5, 0}, {0, 1, 0}}));
}

}  // namespace
}  // namespace shadowlab::live
