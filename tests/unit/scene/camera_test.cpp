#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/scene.h"

namespace shadowlab::scene {
namespace {

double distance(const glm::dvec4& a, const glm::dvec4& b) { return glm::length(a - b); }

TEST(Camera, looks_down_its_own_negative_z) {
  Camera camera;
  camera.eye = {1, 2, 3};
  camera.target = {1, 2, -4};
  // Axes of length one and products of small integers: rounding only.
  EXPECT_LT(distance(camera.view() * glm::dvec4(1, 2, -4, 1), {0, 0, -7, 1}), 1e-14);
  EXPECT_LT(distance(camera.view() * glm::dvec4(2, 2, 3, 1), {1, 0, 0, 1}), 1e-14);
  EXPECT_LT(distance(camera.view() * glm::dvec4(1, 3, 3, 1), {0, 1, 0, 1}), 1e-14);
}

TEST(Camera, projects_near_and_far_to_minus_one_and_one) {
  Camera camera;
  camera.fovy = 90;
  camera.near = 0.5;
  camera.far = 50;
  const glm::dmat4 projection = camera.projection(2.0);
  const auto ndc = [&](glm::dvec4 eye) {
    const glm::dvec4 clip = projection * eye;
    return clip / clip.w;
  };
  EXPECT_LT(distance(ndc({0, 0, -0.5, 1}), {0, 0, -1, 1}), 1e-14);
  EXPECT_LT(distance(ndc({0, 0, -50, 1}), {0, 0, 1, 1}), 1e-14);
  // At 90° the top edge is as high as far away; an aspect of 2 puts the right edge twice as far.
  EXPECT_LT(std::abs(ndc({6, 3, -3, 1}).x - 1.0), 1e-14);
  EXPECT_LT(std::abs(ndc({6, 3, -3, 1}).y - 1.0), 1e-14);
}

TEST(Camera, refuses_what_shows_nothing) {
  const auto refused = [](auto change) {
    Camera camera;
    change(camera);
    EXPECT_THROW(camera.view() * camera.projection(1.0), InputError);
  };
  EXPECT_NO_THROW(Camera().view());
  EXPECT_NO_THROW(Camera().projection(1.0));
  refused([](Camera& c) { c.target = c.eye; });
  refused([](Camera& c) { c.up = c.target - c.eye; });
  refused([](Camera& c) { c.up = glm::dvec3(0); });
  refused([](Camera& c) { c.eye.x = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Camera& c) { c.fovy = 0; });
  refused([](Camera& c) { c.fovy = 180; });
  refused([](Camera& c) { c.near = 0; });
  refused([](Camera& c) { c.far = c.near; });
  refused([](Camera& c) { c.far = std::numeric_limits<double>::infinity(); });
  EXPECT_THROW(Camera().projection(0.0), InputError);
}

}  // namespace
}  // namespace shadowlab::scene
