#include "shadow/penumbra.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "shadow/samples.h"

namespace shadowlab::shadow {
namespace {

using scene::Light;

// A square plate of 2 by 2 at height 1 over a floor, under a light at height 3, seen from straight
// above at height 10: at 90 degrees a picture of 200 pixels is 20 m of the floor.
scene::Scene plate() {
  scene::Scene world;
  const auto object = [&](const char* name, double size, double height, scene::Role role) {
    scene::Object made;
    made.name = name;
    made.mesh = std::make_shared<scene::Mesh>(scene::plane(size, size));
    made.model[3].y = height;
    made.role = role;
    world.objects.push_back(made);
  };
  object("floor", 16, 0, scene::Role::receiver);
  object("plate", 2, 1, scene::Role::caster);
  world.camera.eye = {0, 10, 0};
  world.camera.target = {0, 0, 0};
  world.camera.up = {0, 0, -1};
  world.camera.fovy = 90;
  world.camera.near = 0.1;
  return world;
}

Light square(double half) {
  return {.position = {0, 3, 0, 1},
          .shape = Light::Shape::rectangle,
          .half_u = {half, 0, 0},
          .half_v = {0, 0, half}};
}

// The penumbra's half-width is s h/(H - h) = s/2, and its middle line, the centre's shadow, four
// sides of 3 m; a metre is ten pixels. Without the corners, which the strips leave out.
TEST(Penumbra, of_a_plate_under_a_square_light_is_as_wide_as_similar_triangles_say) {
  for (const double s : {0.1, 0.2, 0.4}) {
    const auto found = penumbra(plate(), plate().camera, square(s), {200, 200});
    EXPECT_NEAR(found.width, 10 * s, 1e-9) << "double";
    EXPECT_NEAR(found.pixels, 10 * s * 4 * 30, 1e-6) << "double";
    EXPECT_NEAR(found.share, found.pixels / 40000, 1e-12);
  }
}

TEST(Penumbra, follows_the_picture_s_pixels_the_light_s_size_and_its_shape) {
  const scene::Scene world = plate();
  const double one = penumbra(world, world.camera, square(0.2), {200, 200}).width;
  EXPECT_NEAR(penumbra(world, world.camera, square(0.2), {400, 400}).width, 2 * one, 1e-9);
  Light sphere = square(0);
  sphere.shape = Light::Shape::sphere;
  sphere.radius = 0.2;
  // From the plate's edge it is seen 1 aside and 2 above, across the ray: its shadow moves as far
  // as that of a horizontal light that is longer by 1/cos of the tilt, √5/2.
  const double tilted = penumbra(world, world.camera, sphere, {200, 200}).width;
  EXPECT_GT(tilted, one);
  EXPECT_NEAR(tilted, one * std::sqrt(1.25), 0.01 * one)
      << "to second order in the radius over the distance, 0.09² at most";
}

TEST(Penumbra, is_nothing_for_a_point_a_direction_and_where_it_is_not_seen) {
  scene::Scene world = plate();
  EXPECT_EQ(penumbra(world, world.camera, Light{.position = {0, 3, 0, 1}}, {200, 200}).pixels, 0);
  Light far = square(1);
  far.position.w = 0;
  EXPECT_EQ(penumbra(world, world.camera, far, {200, 200}).pixels, 0);
  world.camera.target = {0, 20, 0};
  EXPECT_EQ(penumbra(world, world.camera, square(0.2), {200, 200}).pixels, 0);
}

TEST(Penumbra, needs_more_points_the_larger_it_is_and_the_less_error_is_asked_for) {
  EXPECT_EQ(points_for({}, 1e-9), 1);
  int last = 1;
  for (const double share : {0.001, 0.01, 0.1, 1.0}) {
    const Penumbra seen{10, share * 40000, share};
    const int points = points_for(seen, 0.004);
    EXPECT_GE(points, last);
    EXPECT_LE(expected_error(seen, points), 0.004);
    EXPECT_GT(expected_error(seen, points / 2), 0.004);
    EXPECT_GT(points_for(seen, 0.001), points);
    last = points;
  }
}

// Edges across a square light: what the points say of each, against its area. The first
// and second half of a nested pattern differ by enough to bound the error, on average over edges.
TEST(Penumbra, error_of_halves_is_not_too_little_for_patterns_at_random) {
  for (const Pattern pattern : {Pattern::random, Pattern::owen}) {
    for (const int n : {8, 16, 64, 256}) {
      double errors = 0, differences = 0;
      const int trials = 400;
      for (int trial = 0; trial < trials; ++trial) {
        const auto points = unit_square_points(n, pattern, static_cast<std::uint64_t>(trial));
        const double angle = trial * 2.399963, at = (trial + 0.5) / trials * 1.4 - 0.7;
        const glm::dvec2 normal(std::cos(angle), std::sin(angle));
        const auto below = [&](glm::dvec2 p) { return glm::dot(normal, p - 0.5) < at; };
        int first = 0, second = 0, truth = 0;
        for (int i = 0; i < n; ++i) {
          (i < n / 2 ? first : second) += below(points[static_cast<std::size_t>(i)]) ? 1 : 0;
        }
        constexpr int fine = 100;
        for (int i = 0; i < fine * fine; ++i)
          truth += below({(i % fine + 0.5) / fine, (i / fine + 0.5) / fine}) ? 1 : 0;
        const double mean = double(first + second) / n;
        errors += std::pow(mean - double(truth) / (fine * fine), 2);
        differences += std::pow(double(first - second) / (n / 2), 2);
      }
      const double error = std::sqrt(errors / trials),
                   estimate = error_of_halves(std::sqrt(differences / trials));
      // Random points' estimate is right on average: 400 edges leave 10 % either way.
      EXPECT_LT(error, 1.1 * estimate) << pattern_names()[std::size_t(pattern)] << " " << n;
      EXPECT_LT(estimate, 4 * error) << pattern_names()[std::size_t(pattern)] << " " << n;
    }
  }
}

}  // namespace
}  // namespace shadowlab::shadow
