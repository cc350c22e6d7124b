// The planes around one triangle's shadow, and the grid that says which triangles a point is tested
// against.
#include <gtest/gtest.h>

#include <random>

#include "core/error.h"
#include "scene/mesh.h"
#include "shadow/light_view.h"
#include "shadow/triangle_grid.h"
#include "shadow/triangle_shadow.h"

namespace shadowlab::shadow {
namespace {

double value(glm::dvec4 plane, glm::dvec3 p) { return glm::dot(plane, glm::dvec4(p, 1)); }

bool shadows(const TriangleShadow& shadow, glm::dvec3 p) {
  return value(shadow.own, p) < 0 && value(shadow.edges[0], p) >= 0 &&
         value(shadow.edges[1], p) >= 0 && value(shadow.edges[2], p) >= 0;
}

constexpr glm::dvec4 at_origin(0, 0, 0, 1);

// p is a point a + u (b - a) + v (c - a) of the triangle, taken away from the light or toward it.
TEST(TriangleShadow, holds_what_lies_behind_the_triangle_and_nothing_else) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1), space(-2, 2);
  for (int i = 0; i < 2000; ++i) {
    std::array<glm::dvec3, 3> corners;
    for (glm::dvec3& corner : corners) corner = {space(random), space(random), space(random)};
    const bool point_light = i % 2 == 0;
    const glm::dvec4 light =
        point_light ? at_origin : glm::dvec4(space(random), space(random), space(random), 0);
    const TriangleShadow shadow = triangle_shadow(corners, light);
    const double u = 3 * unit(random) - 1, v = 3 * unit(random) - 1;
    const bool inside = u >= 0 && v >= 0 && u + v <= 1;
    const glm::dvec3 p = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
    const glm::dvec3 away = point_light ? p : -glm::dvec3(light);
    EXPECT_EQ(shadows(shadow, p + 0.3 * away), inside);
    EXPECT_FALSE(shadows(shadow, p - 0.3 * away));
    // Beyond a point light nothing is shadowed, though the planes through it go on.
    if (point_light) {
      EXPECT_FALSE(shadows(shadow, -p));
    }
  }
}

TEST(TriangleShadow, has_the_same_numbers_for_an_edge_that_two_triangles_share) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> space(-2, 2);
  const auto point = [&] { return glm::dvec3(space(random), space(random), space(random)); };
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 a = point(), b = point(), c = point(), d = point();
    for (const glm::dvec4 light : {at_origin, glm::dvec4(point(), 0)}) {
      const glm::dvec4 one = triangle_shadow({a, b, c}, light).edges[0];
      const glm::dvec4 other = triangle_shadow({b, a, d}, light).edges[0];
      EXPECT_TRUE(one == other || one == -other);
    }
  }
}

// Corners are relative to the light, each rounded by 2^-53 of the way to it. Some 16 roundings in
// all move a plane by so much, and turn it the more the nearer its edge points at the light.
TEST(TriangleShadow, of_a_far_light_is_off_by_no_more_than_its_corners_are) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> space(-1, 1);
  const auto point = [&] { return glm::dvec3(space(random), space(random), space(random)); };
  for (const double away : {1e2, 1e4, 1e6, 1e8}) {
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 light = away * glm::normalize(point());
      const std::array corners{point() - light, point() - light, point() - light};
      const TriangleShadow shadow = triangle_shadow(corners, at_origin);
      if (shadow.own == glm::dvec4(0)) continue;
      const glm::dvec3 n(shadow.own);
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
        const glm::dvec3 edge = glm::normalize(b - a), in = glm::cross(n, edge);
        const glm::dvec3 side = glm::cross(edge, a / glm::length(a));
        const double slack = 16 * 0x1p-53 * away / glm::length(side);
        EXPECT_NEAR(value(shadow.edges[k], (a + b) * 0.5), 0, slack);
        // The third corner's: the triangle's height over the edge, by how the planes are inclined.
        const double height = std::abs(glm::dot(c - a, in));
        const double sine = std::abs(glm::dot(in, side)) / glm::length(side);
        EXPECT_NEAR(value(shadow.edges[k], c), height * sine, slack);
      }
    }
  }
}

TEST(TriangleShadow, is_empty_for_a_triangle_without_area_or_with_the_light_in_its_plane) {
  const glm::dvec3 a(1, 1, 2), b(2, -1, 3);
  EXPECT_EQ(triangle_shadow({a, b, a}, at_origin).own, glm::dvec4(0));
  EXPECT_EQ(triangle_shadow({a, b, a + b}, at_origin).own, glm::dvec4(0));
  EXPECT_EQ(triangle_shadow({a, b, a + glm::dvec3(0, 0, 1)}, {0, 0, 1, 0}).own, glm::dvec4(0));
  EXPECT_NE(triangle_shadow({a, b, {0, 0, 3}}, at_origin).own, glm::dvec4(0));
}

scene::Scene boxes() {
  scene::Scene scene;
  const auto add = [&](scene::Mesh mesh, glm::dvec3 place, scene::Role role) {
    scene::Object object;
    object.name = "object";
    object.mesh = std::make_shared<scene::Mesh>(std::move(mesh));
    object.model[3] = glm::dvec4(place, 1);
    object.role = role;
    scene.objects.push_back(std::move(object));
  };
  add(scene::plane(8, 8), {0, 0, 0}, scene::Role::receiver);
  add(scene::box({1, 1, 1}), {0, 1, 0}, scene::Role::both);
  add(scene::box({1, 2, 1}), {1.2, 1.5, 0.4}, scene::Role::both);
  add(scene::box({3, 0.1, 3}), {0, 0.3, 0}, scene::Role::caster);
  return scene;
}

// Every point of the scene is asked twice: all casters' triangles, and its cell's.
TEST(TriangleGrid, lists_in_each_cell_what_says_the_same_as_all_triangles) {
  const scene::Scene scene = boxes();
  for (const glm::dvec4 light : {glm::dvec4(2, 5, 1, 1), glm::dvec4(0.4, 1, 0.2, 0)}) {
    const LightView view = light_view(light, scene, whole_content(scene));
    for (const int cells : {1, 7, 64}) {
      const TriangleGrid grid = triangle_grid(scene, light, view.view, view.projection, cells);
      const auto record = [&](std::size_t triangle, std::size_t i) {
        const glm::vec4* texels = grid.triangles.data() + triangle * TriangleGrid::texels;
        return glm::dvec4(texels[i]) + glm::dvec4(texels[4 + i]);
      };
      const auto shadowed_by = [&](std::size_t triangle, glm::dvec3 p) {
        TriangleShadow shadow{record(triangle, 0), {}};
        for (std::size_t i = 0; i < 3; ++i) shadow.edges[i] = record(triangle, i + 1);
        return shadows(shadow, p);
      };
      std::mt19937 random(5);
      std::uniform_real_distribution<double> place(-3, 3), height(0, 2);
      int dark = 0;
      for (int k = 0; k < 3000; ++k) {
        const glm::dvec3 p(place(random), height(random), place(random));
        const glm::dvec4 clip = view.projection * (view.view * glm::dvec4(p, 1));
        const glm::dvec2 at = (glm::dvec2(clip) / clip.w + 1.0) * 0.5;
        if (at.x < 0 || at.y < 0 || at.x >= 1 || at.y >= 1) continue;
        bool all = false, listed = false;
        for (std::size_t t = 2; t < 2 + 36; ++t) all = all || shadowed_by(t, p - grid.origin);
        const auto range =
            grid.ranges[static_cast<std::size_t>(at.y * cells) * static_cast<std::size_t>(cells) +
                        static_cast<std::size_t>(at.x * cells)];
        for (std::uint32_t i = 0; i < range.y; ++i)
          listed = listed || shadowed_by(grid.list[range.x + i], p - grid.origin);
        EXPECT_EQ(all, listed);
        dark += all;
      }
      EXPECT_GT(dark, 100);
    }
  }
}

// A cell that a triangle covers lists no more than is before it: a closed caster's far sides are
// left out, and a hundred of them inside of each other cost as much as one.
TEST(TriangleGrid, leaves_out_what_lies_behind_a_triangle_that_covers_the_cell) {
  scene::Scene scene = boxes();
  const glm::dvec4 light(0.1, 1, 0.05, 0);
  const LightView view = light_view(light, scene, whole_content(scene));
  const auto listed = [&] {
    return triangle_grid(scene, light, view.view, view.projection, 64).list.size();
  };
  const std::size_t before = listed();
  for (int i = 0; i < 100; ++i) {
    scene.objects.push_back(scene.objects[3]);
    auto& hidden = scene.objects.back();
    hidden.mesh = std::make_shared<scene::Mesh>(scene::box({2.5, 0.05, 2.5}));
    hidden.model[3] = glm::dvec4(0, 0.3, 0, 1);
  }
  // What is hidden reaches into the cells along the cover's rim and diagonal alone.
  EXPECT_LT(listed(), before + 100 * 12 * 64);
}

TEST(TriangleGrid, refuses_a_number_of_cells_that_is_none) {
  const scene::Scene scene = boxes();
  EXPECT_THROW(triangle_grid(scene, {0, 1, 0, 0}, glm::dmat4(1), glm::dmat4(1), 0), InputError);
  EXPECT_THROW(triangle_grid(scene, {0, 1, 0, 0}, glm::dmat4(1), glm::dmat4(1), 5000), InputError);
}

}  // namespace
}  // namespace shadowlab::shadow
