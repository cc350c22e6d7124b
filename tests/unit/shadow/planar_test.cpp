#include "shadow/planar.h"

#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

const dvec4 ground(0, 1, 0, 0);
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The lecture's listing: P·L on the diagonal, less L Pᵀ.
dmat4 listing(dvec4 plane, dvec4 light) {
  return dmat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

dvec3 position(dvec4 v) { return dvec3(v) / v.w; }
dvec3 image(const dmat4& m, dvec3 v) { return position(m * dvec4(v, 1.0)); }

double distance(const dmat4& a, const dmat4& b) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum);
}

// --- Where shadows fall ------------------------------------------------------------------------

TEST(Planar, throws_from_a_point_to_where_the_ray_meets_the_plane) {
  const dmat4 m = planar(ground, {2, 4, 1, 1});
  // From (2, 4, 1) through (1, 2, 1): twice as far as the caster. Exact: powers of two.
  EXPECT_EQ(image(m, {1, 2, 1}), dvec3(0, 0, 1));
  EXPECT_EQ(image(m, {2, 3, 1}), dvec3(2, 0, 1));    // below the light
  EXPECT_EQ(image(m, {7, 0, -3}), dvec3(7, 0, -3));  // a point of the plane stays
  EXPECT_EQ(image(m, {3, 3, 3}), dvec3(6, 0, 9));
}

TEST(Planar, throws_along_a_direction) {
  const dmat4 m = planar(ground, {1, 2, -1, 0});
  EXPECT_EQ(image(m, {5, 4, 3}), dvec3(3, 0, 5));
  EXPECT_EQ(image(m, {5, 0, 3}), dvec3(5, 0, 3));
}

TEST(Planar, throws_on_an_oblique_plane) {
  // x + y + z = 3 from (0, 0, 0) through (0.5, 0.5, 0.5) and (1, 0, 0).
  const dmat4 m = planar({1, 1, 1, -3}, {0, 0, 0, 1});
  EXPECT_EQ(image(m, {0.5, 0.5, 0.5}), dvec3(1, 1, 1));
  EXPECT_EQ(image(m, {1, 0, 0}), dvec3(3, 0, 0));
}

TEST(Planar, on_z_0_from_the_z_axis_at_infinity_drops_z) {
  // The lecture's case P = L = (0, 0, 1, 0).
  dmat4 expected(1.0);
  expected[2][2] = 0.0;
  EXPECT_EQ(planar({0, 0, 1, 0}, {0, 0, 1, 0}), expected);
}

TEST(Planar, is_the_listing_up_to_a_power_of_two) {
  const dmat4 m = planar(ground, {2, 4, 1, 1});
  EXPECT_EQ(4.0 * m, listing(ground, {2, 4, 1, 1}));
  const dmat4 n = planar({1, 2, 2, -3}, {3, 5, 7, 1});
  EXPECT_EQ(16.0 * n, listing({1, 2, 2, -3}, {3, 5, 7, 1}));
  EXPECT_EQ((n * dvec4(3, 0, 0, 1)).w, 24.0 / 16.0);  // P·L of a point of the plane: in [1, 2)
}

TEST(Planar, projects_twice_as_once) {
  const dmat4 m = planar({1, 2, 2, -3}, {3, 5, 7, 1});
  // M M = (P·L) M: whole numbers, exact.
  EXPECT_EQ(m * m, 1.5 * m);
}

TEST(Planar, has_the_lectures_three_forms) {
  const dvec4 plane(1, 2, 2, -3);
  EXPECT_EQ(planar_from_origin(plane), planar(plane, {0, 0, 0, 1}));
  EXPECT_EQ(planar_from_point(plane, {3, 5, 7}), planar(plane, {3, 5, 7, 1}));
  EXPECT_EQ(planar_along(plane, {1, 2, -1}), planar(plane, {1, 2, -1, 0}));
  EXPECT_EQ(image(planar_from_origin({0, 1, 0, -4}), {1, 2, 3}), dvec3(2, 4, 6));
  EXPECT_EQ(image(planar_from_point(ground, {0, 4, 0}), {1, 2, 3}), dvec3(2, 0, 6));
  EXPECT_EQ(image(planar_along(ground, {1, -1, 0}), {1, 2, 3}), dvec3(3, 0, 3));
}

// --- Row by row, the hard cases ----------------------------------------------------------------

TEST(Planar, along_a_direction_or_its_opposite_is_the_same_matrix) {
  const dvec4 plane(0.3, 0.8, -0.2, 1.7);
  EXPECT_EQ(planar_along(plane, {0.1, -0.9, 0.4}), planar_along(plane, {-0.1, 0.9, -0.4}));
}

TEST(Planar, from_a_light_at_distance_d_nears_the_direction_as_one_over_d) {
  // On y = 0 along (1, 2, 0), the shadow of (0, h) is at −h/2; from D·(1, 2) it is h²/(2 (2D − h))
  // further.
  const double h = 3.0;
  EXPECT_EQ(image(planar(ground, {1, 2, 0, 0}), {0, h, 0}).x, -h / 2);
  for (const double d : {1e1, 1e2, 1e3, 1e4, 1e5}) {
    const double moved = image(planar(ground, {d, 2 * d, 0, 1}), {0, h, 0}).x + h / 2;
    // The difference of positions of order one has 1e-16 of error.
    EXPECT_NEAR(moved, -h * h / (2.0 * (2.0 * d - h)), 1e-15) << d;
  }
  // The homogeneous form leads there without a jump: (x, y, z, w → 0).
  EXPECT_LT(distance(planar(ground, {1, 2, 0, 1e-12}), planar(ground, {1, 2, 0, 0})), 4e-12);
}

void expect_refused(dvec4 plane, dvec4 light, const char* reason) {
  try {
    const dmat4 m = planar(plane, light);
    ADD_FAILURE() << "accepted: " << reason << m[0][0];
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(reason));
  }
  EXPECT_THROW(planar_near(plane, light, dvec3(0)), InputError);
  EXPECT_THROW(plane_toward(plane, light), InputError);
}

TEST(Planar, refuses_a_light_in_the_plane_with_the_reason) {
  expect_refused(ground, {3, 0, 1, 1}, "in the shadow plane");
  expect_refused(ground, {3, 0, 1, 0}, "along the shadow plane");
  expect_refused({0, 1, 0, -1e6}, {3, 1e6, 1, 1}, "in the shadow plane");
  // Within rounding: a plane through a point that the light is also in, a million units away.
  const dvec3 normal = glm::normalize(dvec3(1, 2, 3));
  const dvec3 in_plane = glm::cross(normal, glm::normalize(dvec3(3, 1, -1)));
  for (int i = 1; i <= 20; ++i) {
    const dvec3 point = dvec3(1e6, -2e6, 3e6) / static_cast<double>(i);
    const dvec3 light = point + (5.0 * i) * in_plane;
    expect_refused(dvec4(normal, -glm::dot(normal, point)), dvec4(light, 1), "in the shadow plane");
  }
  expect_refused(dvec4(normal, 0), dvec4(in_plane, 0), "along the shadow plane");
  // A micrometre above the plane is a light like any other.
  EXPECT_NO_THROW(planar(ground, {3, 1e-6, 1, 1}));
  EXPECT_NO_THROW(planar({0, 1, 0, -1e6}, {3, 1e6 + 1e-6, 1, 1}));
}

TEST(Planar, refuses_what_is_no_plane_or_no_light) {
  expect_refused({0, 0, 0, 1}, {0, 1, 0, 1}, "normal is zero");
  expect_refused({0, 0, 0, 0}, {0, 1, 0, 1}, "normal is zero");
  expect_refused({1e-300, 0, 0, 1e300}, {0, 1, 0, 1}, "normal is zero");
  expect_refused(ground, {0, 0, 0, 0}, "(0, 0, 0, 0)");
  expect_refused({0, nan, 0, 0}, {0, 1, 0, 1}, "plane's four numbers");
  expect_refused(ground, {0, infinity, 0, 1}, "light's four numbers");
  EXPECT_THROW(planar_near(ground, {0, 1, 0, 1}, dvec3(nan)), InputError);
}

TEST(Planar, stays_finite_for_any_finite_scale) {
  for (const double scale : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    const dmat4 m = planar(ground * scale, dvec4(2, 4, 1, 1) * scale);
    EXPECT_LT(glm::length(image(m, {1, 2, 1}) - dvec3(0, 0, 1)), 1e-14) << scale;
  }
}

TEST(Planar, sends_a_vertex_at_the_lights_height_to_infinity) {
  const dmat4 m = planar(ground, {2, 4, 1, 1});
  const dvec4 level = m * dvec4(5, 4, 2, 1);
  EXPECT_EQ(level.w, 0.0);
  // Its shadow is the direction away from the light, not its opposite.
  EXPECT_EQ(dvec3(level), dvec3(3, 0, 1));
  // Just below it is far that way; just above it is behind the eye of GL's clipping: no
  // wrap-around.
  const dvec4 below = m * dvec4(5, 4 - 1e-9, 2, 1);
  EXPECT_GT(below.w, 0.0);
  EXPECT_GT(position(below).x, 1e9);
  EXPECT_LT((m * dvec4(5, 4 + 1e-9, 2, 1)).w, 0.0);
}

TEST(Planar, is_the_same_matrix_for_the_plane_turned_over) {
  const dvec4 plane(0.3, 0.8, -0.2, 1.7), light(2, 5, 3, 1);
  EXPECT_EQ(planar(-plane, light), planar(plane, light));
  EXPECT_EQ(planar(plane, -light), planar(plane, light));
  // The listing's is not: its shadow of a caster below the light has w' < 0, and GL drops it.
  EXPECT_LT((listing(-ground, {0, 4, 0, 1}) * dvec4(1, 2, 0, 1)).w, 0.0);
  EXPECT_GT((planar(-ground, {0, 4, 0, 1}) * dvec4(1, 2, 0, 1)).w, 0.0);
}

TEST(Planar, plane_toward_has_a_unit_normal_and_the_light_above) {
  EXPECT_EQ(plane_toward({0, -2, 0, 6}, {0, 4, 0, 1}), dvec4(0, 1, 0, -3));
  EXPECT_EQ(plane_toward({0, -2, 0, 6}, {0, 1, 0, 1}), dvec4(0, -1, 0, 3));
  EXPECT_EQ(plane_toward({0, -2, 0, 6}, {1, 1, 0, 0}), dvec4(0, 1, 0, -3));
  EXPECT_EQ(plane_toward({0, -2, 0, 6}, {0, -4, 0, -1}), dvec4(0, 1, 0, -3));
}

TEST(PlanarReach, tells_casters_below_the_plane_and_above_the_light) {
  const dvec4 light(0, 4, 0, 1), sun(1, 1, 0, 0);
  const auto box = [](double low, double high) {
    return scene::Bounds{{-1, low, -1}, {1, high, 1}};
  };
  for (const dvec4& plane : {ground, -ground}) {
    EXPECT_EQ(planar_reach(plane, light, box(1, 2)), PlanarReach::whole);
    EXPECT_EQ(planar_reach(plane, light, box(0, 2)), PlanarReach::whole);  // stands on it
    EXPECT_EQ(planar_reach(plane, light, box(-1, 2)), PlanarReach::part);
    EXPECT_EQ(planar_reach(plane, light, box(3, 5)), PlanarReach::part);
    EXPECT_EQ(planar_reach(plane, light, box(-2, -1)), PlanarReach::none);
    EXPECT_EQ(planar_reach(plane, light, box(-2, 0)), PlanarReach::none);
    EXPECT_EQ(planar_reach(plane, light, box(0, 0)), PlanarReach::none);  // the receiver itself
    EXPECT_EQ(planar_reach(plane, light, box(4, 5)), PlanarReach::none);
    EXPECT_EQ(planar_reach(plane, sun, box(4, 5)), PlanarReach::whole);
    EXPECT_EQ(planar_reach(plane, sun, box(-2, -1)), PlanarReach::none);
  }
  EXPECT_EQ(planar_reach(ground, light, scene::Bounds{}), PlanarReach::none);
}

TEST(PlanarReach, takes_the_corners_of_the_box_along_an_oblique_plane) {
  // x + y = 0 from (4, 4, 0): the box's corner (1, 1) is above, (−1, −1) below.
  const dvec4 plane(1, 1, 0, 0), light(4, 4, 0, 1);
  EXPECT_EQ(planar_reach(plane, light, {{-1, -1, 0}, {1, 1, 1}}), PlanarReach::part);
  EXPECT_EQ(planar_reach(plane, light, {{1, -1, 0}, {2, 1, 1}}), PlanarReach::whole);
  EXPECT_EQ(planar_reach(plane, light, {{-3, -1, 0}, {-2, 1, 1}}), PlanarReach::none);
}

TEST(Planar, throws_a_caster_below_the_plane_or_above_the_light_where_there_is_no_shadow) {
  // What `planar_reach` is for: below the plane w' > 0, and M alone draws a false shadow.
  const dmat4 m = planar(ground, {0, 4, 0, 1});
  EXPECT_GT((m * dvec4(1, -1, 0, 1)).w, 0.0);
  EXPECT_LT((m * dvec4(1, 5, 0, 1)).w, 0.0);
}

/// Double the signed area of the shadow of a triangle on y = 0.
double shadow_area(const dmat4& m, const std::array<dvec3, 3>& face) {
  const dvec3 a = image(m, face[0]), b = image(m, face[1]), c = image(m, face[2]);
  return glm::cross(b - a, c - a).y;
}

TEST(Planar, changes_a_faces_shadow_without_a_jump_as_the_light_crosses_its_plane) {
  // A face in x = 0; from (s, 4, 0) the shadow of (0, y, z) is (−s y, 4 z)/(4 − y).
  const std::array<dvec3, 3> face{{{0, 1, 0}, {0, 2, 0}, {0, 1, 1}}};
  for (double s = -1e-3; s <= 1e-3; s += 1e-5) {
    const double area = shadow_area(planar(ground, {s, 4, 0, 1}), face);
    // ((−s) − (−s/3)) · 4/3 along x and z; of numbers of order one, so 1e-15.
    EXPECT_NEAR(std::abs(area), std::abs(s) * 8.0 / 9.0, 1e-15);
    EXPECT_EQ(std::signbit(area), s < 0.0) << s;
  }
}

}  // namespace
}  // namespace shadowlab::shadow
