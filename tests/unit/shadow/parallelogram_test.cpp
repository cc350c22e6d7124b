// The matrix that maps a receiver's parallelogram to the unit square; with planar.h.
#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shadow/planar.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

dvec3 image(const dmat4& m, dvec3 v) {
  const dvec4 p = m * dvec4(v, 1.0);
  return dvec3(p) / p.w;
}

TEST(Parallelogram, maps_the_receiver_to_the_unit_square_at_depth_1) {
  const dvec3 corner(-2, 0, 3), ex(4, 0, 1), ey(1, 0, -6);
  for (const dvec4& light : {dvec4(1, 5, 0, 1), dvec4(1, 2, 1, 0), dvec4(1, -5, 0, 1)}) {
    const dmat4 m = parallelogram(corner, ex, ey, light);
    for (const double s : {0.0, 0.25, 1.0}) {
      for (const double t : {0.0, 0.5, 1.0}) {
        const dvec3 found = image(m, corner + s * ex + t * ey);
        EXPECT_LT(glm::length(found - dvec3(s, t, 1)), 1e-14);  // order-one arithmetic
      }
    }
  }
}

TEST(Parallelogram, maps_a_caster_to_its_shadow) {
  const dvec3 corner(-4, 0, -4), ex(8, 0, 0), ey(0, 0, 8), v(1, 1.5, -0.5);
  for (const dvec4& light : {dvec4(1, 5, 2, 1), dvec4(1, 3, 1, 0)}) {
    const dvec3 shadow = image(planar({0, 1, 0, 0}, light), v);
    const dvec3 found = image(parallelogram(corner, ex, ey, light), v);
    EXPECT_NEAR(found.x, (shadow.x + 4) / 8, 1e-14);
    EXPECT_NEAR(found.y, (shadow.z + 4) / 8, 1e-14);
  }
}

TEST(Parallelogram, orders_depth_from_the_light_to_the_receiver_and_beyond) {
  const dmat4 point = parallelogram({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0.5, 4, 0.5, 1});
  EXPECT_NEAR(image(point, {0.5, 4 - 4.0 / 1024, 0.5}).z, 0.0, 1e-12);  // (1 − 1)/(1/1024)
  const dmat4 sun = parallelogram({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 3, 0, 0});
  EXPECT_NEAR(image(sun, {0.5, 1024, 0.5}).z, 0.0, 1e-14);
  for (const dmat4& m : {point, sun}) {
    double last = image(m, {0.5, 3.9, 0.5}).z;
    EXPECT_GT(last, 0.0);
    for (int i = 0; i < 60; ++i) {
      const double y = 3.85 - 0.1 * i;
      const dvec4 v = m * dvec4(0.5, y, 0.5, 1);
      EXPECT_GT(v.w, 0.0);
      EXPECT_GT(v.z / v.w, last);
      EXPECT_EQ(v.z / v.w > 1.0, y < 0.0);
      last = v.z / v.w;
    }
  }
  EXPECT_LT((point * dvec4(0.5, 5, 0.5, 1)).w, 0.0);  // behind the light: clipped
}

TEST(Parallelogram, refuses_a_light_in_its_plane_and_sides_that_span_none) {
  EXPECT_THROW(parallelogram(dvec3(0), {1, 0, 0}, {0, 0, 1}, {5, 0, 2, 1}), InputError);
  EXPECT_THROW(parallelogram(dvec3(0), {1, 0, 0}, {0, 0, 1}, {5, 0, 2, 0}), InputError);
  EXPECT_THROW(parallelogram(dvec3(0), {1, 0, 0}, {2, 0, 0}, {0, 4, 0, 1}), InputError);
  EXPECT_THROW(parallelogram(dvec3(0), {0, 0, 0}, {2, 0, 0}, {0, 4, 0, 1}), InputError);
  EXPECT_THROW(parallelogram(dvec3(0), {1, 0, 0}, {0, 0, 1}, {0, 0, 0, 0}), InputError);
  EXPECT_THROW(parallelogram(dvec3(nan), {1, 0, 0}, {0, 0, 1}, {0, 4, 0, 1}), InputError);
}

}  // namespace
}  // namespace shadowlab::shadow
