#include "truth/crossing.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "scene/mesh.h"

namespace shadowlab::truth {
namespace {

double next(double value) { return std::nextafter(value, std::numeric_limits<double>::infinity()); }

std::vector<Triangle> triangles(const scene::Mesh& mesh) {
  std::vector<Triangle> result;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto vertex = [&](std::size_t corner) {
      return glm::dvec3(mesh.positions[mesh.indices[3 * t + corner]]);
    };
    result.push_back({vertex(0), vertex(1), vertex(2)});
  }
  return result;
}

TEST(Side, is_positive_where_the_triangle_turns_counter_clockwise) {
  const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(side(t, {0.2, 0.2, 3, 1}), 3);
  EXPECT_EQ(side(t, {0.2, 0.2, -3, 1}), -3);
  EXPECT_EQ(side(t, {5, 5, 2, 0}), 2);
  EXPECT_EQ(side(t, {5, 5, 0, 1}), 0);
}

// A point in the plane, then moved by one unit in the last place: the sign follows, though the
// double determinant is all rounding. Plane x + y + z = 1 through doubles that lie on it exactly.
TEST(Side, is_exact_one_unit_in_the_last_place_from_the_plane) {
  const Triangle t{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> bits(1, (std::int64_t{1} << 50) - 1);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::ldexp(static_cast<double>(bits(random)), -52);
    const double y = std::ldexp(static_cast<double>(bits(random)), -52);
    const double z = 1 - x - y;  // exact: multiples of 2^-52 below 1
    ASSERT_EQ(side(t, {x, y, z, 1}), 0);
    ASSERT_GT(side(t, {next(x), y, z, 1}), 0);
    ASSERT_LT(side(t, {x, y, -next(-z), 1}), 0);
  }
}

// Around a line x = t d far from the plane's origin, where the differences themselves round.
TEST(Side, is_exact_where_the_differences_round) {
  const double big = 0x1p40;
  const Triangle t{{big, big, 1}, {-1, 0, 0}, {0x1p-30, 0x1p-30, 0}};
  for (const double e : {0x1p-60, 0x1p-40}) {
    const glm::dvec3 above(-0.5 + e / 4, 0x1p-31, 0);
    // Antisymmetric: swapping two vertices negates, whatever the rounding.
    EXPECT_EQ(side(t, glm::dvec4(above, 1)), -side({t.b, t.a, t.c}, glm::dvec4(above, 1)));
    EXPECT_EQ(side(t, glm::dvec4(t.b, 1)), 0);
    EXPECT_EQ(side(t, glm::dvec4(t.c, 1)), 0);
    EXPECT_EQ(side(t, glm::dvec4(t.a, 1)), 0);
  }
}

// From inside a closed mesh every line leaves it, also exactly through vertices and edges.
TEST(Line, through_vertices_and_edges_of_a_closed_mesh_meets_a_triangle) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-0.05, 0.05), share(0, 1);
  for (const scene::Mesh& mesh :
       {scene::sphere(1, 16, 9), scene::box(), scene::tetrahedron(1), scene::sphere(1, 3, 2)}) {
    const auto all = triangles(mesh);
    for (int k = 0; k < 40; ++k) {
      const glm::dvec3 inside(uniform(random), uniform(random), uniform(random));
      for (const Triangle& aimed : all) {
        for (const double s : {0.0, 0.25, 0.5, share(random)}) {
          const glm::dvec3 target = aimed.a + s * (aimed.b - aimed.a);
          const Line line(inside, target - inside);
          int ahead = 0;
          for (const Triangle& t : all) {
            const auto crossing = line.crossing(t);
            ahead += crossing && line.parameter(t, *crossing) > 0;
          }
          ASSERT_GE(ahead, 1);
        }
      }
    }
  }
}

// Edge a-b projects to rounded points whose cross product is nothing but rounding: the closed
// triangle on the one side has the line, the one on the other side does not.
TEST(Line, is_on_one_side_of_an_edge_unless_it_is_on_it_exactly) {
  const double e = 0x1p-52;
  const glm::dvec3 a(1 + e, 1 + 2 * e, 1), b(-1 - e, -1 - 2 * e, 1);
  const glm::dvec3 nearly(-1 - 2 * e, -1 - 3 * e, 1);  // (1+e)(1+3e) < (1+2e)²
  const Line line({0, 0, 0}, {0, 0, 1});
  EXPECT_TRUE(line.crossing({a, b, {-5, 5, 1}}));
  EXPECT_TRUE(line.crossing({b, a, {5, -5, 1}}));
  const bool left = line.crossing({a, nearly, {-5, 5, 1}}).has_value();
  const bool right = line.crossing({nearly, a, {5, -5, 1}}).has_value();
  EXPECT_NE(left, right);
}

TEST(Line, in_the_plane_of_a_triangle_does_not_meet_it) {
  const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(Line({-1, 0.2, 0}, {1, 0, 0}).crossing(t));
  EXPECT_FALSE(Line({-1, 0, 0}, {1, 0, 0}).crossing(t));
}

TEST(Line, crosses_where_the_barycentric_coordinates_say) {
  const Triangle t{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  const Line line({1, 2, 10}, {0, 0, -2});
  const auto crossing = line.crossing(t);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(line.parameter(t, *crossing), 4);
  EXPECT_EQ(point_at(t, *crossing).point, glm::dvec3(1, 2, 2));
  EXPECT_EQ(point_at(t, *crossing).rounding.z, 0);  // flat in z: exact
}

TEST(PlanePoint, is_on_its_own_plane_and_on_no_other_through_a_near_point) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 20000; ++i) {
    const Triangle t{any(), any(), any()};
    const glm::dvec3 eye = 3.0 * any();
    const auto crossing = Line(eye, (t.a + t.b + t.c) / 3.0 - eye).crossing(t);
    ASSERT_TRUE(crossing);
    const PlanePoint p = point_at(t, *crossing);
    ASSERT_TRUE(on_plane(t, p, side(t, glm::dvec4(p.point, 1))));
    // Lifted by 1e-12 along the normal, a thousand times the rounding, it is off the plane.
    const glm::dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    const PlanePoint lifted{p.point + 1e-12 * normal, p.rounding};
    ASSERT_FALSE(on_plane(t, lifted, side(t, glm::dvec4(lifted.point, 1))));
  }
}

}  // namespace
}  // namespace shadowlab::truth
