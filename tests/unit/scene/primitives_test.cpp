#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/mesh.h"
#include "topology.h"

namespace shadowlab::scene {
namespace {

struct Named {
  const char* name;
  Mesh mesh;
};

std::vector<Named> closed_primitives() {
  return {{"box", box({1, 2, 3})},
          {"sphere", sphere()},
          {"coarsest sphere", sphere(1.0, 3, 2)},
          {"torus", torus()},
          {"coarsest torus", torus(1.0, 0.5, 3, 3)},
          {"tetrahedron", tetrahedron()}};
}

std::vector<Named> all_primitives() {
  std::vector<Named> all = closed_primitives();
  const std::vector<double> hills{0, 0.5, 0, 0.25, 0, 0.75, 0, 0.5, 0};
  all.push_back({"plane", plane(4, 2, 3, 5)});
  all.push_back({"quad", quad()});
  all.push_back({"grid", grid(4, 2, 2, 2, hills)});
  return all;
}

TEST(Primitives, keep_the_invariants_of_a_mesh_and_have_unit_normals_and_uvs) {
  for (const auto& [name, mesh] : all_primitives()) {
    EXPECT_NO_THROW(check(mesh)) << name;
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << name;
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size()) << name;
    for (const glm::vec3& n : mesh.normals) {
      // Rounding three components to float moves the length by at most 1e-7.
      EXPECT_NEAR(glm::length(glm::dvec3(n)), 1.0, 2e-7) << name;
    }
    for (const glm::vec2& uv : mesh.uvs) {
      EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1) << name;
    }
  }
}

TEST(Primitives, have_no_degenerate_triangle) {
  for (const auto& [name, mesh] : all_primitives())
    EXPECT_EQ(degenerate_triangles(mesh), 0) << name;
}

TEST(Primitives, face_the_way_of_their_normals) {
  for (const auto& [name, mesh] : all_primitives()) {
    EXPECT_GT(least_normal_agreement(mesh), 0.0) << name;
  }
}

TEST(Primitives, that_are_closed_are_watertight_by_position) {
  for (const auto& [name, mesh] : closed_primitives()) EXPECT_EQ(open_edges(mesh), 0) << name;
}

TEST(Primitives, that_are_closed_enclose_their_volume) {
  // Sums of some thousand float triangles: 1e-6 relative.
  EXPECT_NEAR(volume(box({1, 2, 3})), 6.0, 1e-6);
  // A regular tetrahedron of circumradius R has the volume 8 √3 R³ / 27.
  EXPECT_NEAR(volume(tetrahedron(1.0)), 8.0 * std::sqrt(3.0) / 27.0, 1e-6);
  // Inscribed in the sphere and the torus, whose volumes they approach as 1/n²: (2π/64)²/6·… < 0.5
  // %.
  const double pi = std::numbers::pi;
  EXPECT_NEAR(volume(sphere(1.0, 64, 64)) / (4.0 / 3.0 * pi), 1.0, 5e-3);
  EXPECT_LT(volume(sphere(1.0, 64, 64)), 4.0 / 3.0 * pi);
  EXPECT_NEAR(volume(torus(1.0, 0.25, 128, 64)) / (2.0 * pi * pi * 0.0625), 1.0, 5e-3);
}

TEST(Primitives, that_are_flat_face_as_said) {
  EXPECT_EQ(plane_of(plane(4, 2, 3, 5)), glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(plane_of(quad()), glm::dvec4(0, 0, 1, 0));
  EXPECT_DOUBLE_EQ(area(plane(4, 2, 3, 5)), 8.0);
  EXPECT_DOUBLE_EQ(area(quad()), 4.0);
}

TEST(Primitives, have_the_sizes_asked_for_exactly) {
  const auto expect_box = [](const Mesh& mesh, glm::dvec3 low, glm::dvec3 high) {
    EXPECT_EQ(bounds(mesh).low, low);
    EXPECT_EQ(bounds(mesh).high, high);
  };
  expect_box(plane(4, 2, 3, 5), {-2, 0, -1}, {2, 0, 1});
  expect_box(quad(), {-1, -1, 0}, {1, 1, 0});
  expect_box(box({1, 2, 3}), {-0.5, -1, -1.5}, {0.5, 1, 1.5});
  expect_box(sphere(0.5, 32, 16), glm::dvec3(-0.5), glm::dvec3(0.5));
  expect_box(torus(0.5, 0.25, 48, 24), {-0.75, -0.25, -0.75}, {0.75, 0.25, 0.75});
}

TEST(Primitives, of_revolution_lie_on_their_surfaces) {
  for (const glm::vec3& p : sphere(0.5).positions) {
    EXPECT_NEAR(glm::length(glm::dvec3(p)), 0.5, 1e-7);  // float positions
  }
  for (const glm::vec3& p : torus(0.5, 0.2).positions) {
    EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 0.5, p.y), 0.2, 1e-7);
  }
  EXPECT_EQ(tetrahedron(2.0).positions.front(), glm::vec3(0, 2, 0));
  for (const glm::vec3& p : tetrahedron(2.0).positions) {
    EXPECT_NEAR(glm::length(glm::dvec3(p)), 2.0, 3e-7);
  }
}

TEST(Primitives, grid_puts_each_height_at_its_column_and_row) {
  const std::vector<double> heights{0, 1, 2, 3, 4, 5};
  const Mesh mesh = grid(4, 2, 2, 1, heights);
  EXPECT_EQ(mesh.positions[0], glm::vec3(-2, 0, -1));
  EXPECT_EQ(mesh.positions[2], glm::vec3(2, 2, -1));
  EXPECT_EQ(mesh.positions[3], glm::vec3(-2, 3, 1));
  EXPECT_EQ(mesh.triangle_count(), 4u);
}

TEST(Primitives, refuse_nonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(plane(0, 1), InputError);
  EXPECT_THROW(plane(1, -1), InputError);
  EXPECT_THROW(plane(1, nan), InputError);
  EXPECT_THROW(plane(1, 1, 0, 1), InputError);
  EXPECT_THROW(plane(1, 1, 1, std::numeric_limits<int>::max()), InputError);
  EXPECT_THROW(box({1, infinity, 1}), InputError);
  EXPECT_THROW(sphere(0.5, 2, 16), InputError);
  EXPECT_THROW(sphere(0.5, 32, 1), InputError);
  EXPECT_THROW(torus(0.2, 0.5), InputError);
  EXPECT_THROW(tetrahedron(nan), InputError);
  EXPECT_THROW(grid(1, 1, 1, 1, std::vector<double>{0, 0, 0}), InputError);
  EXPECT_THROW(grid(1, 1, 1, 1, std::vector<double>{0, 0, 0, nan}), InputError);
}

}  // namespace
}  // namespace shadowlab::scene
