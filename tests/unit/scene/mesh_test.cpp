#include "scene/mesh.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "topology.h"

namespace shadowlab::scene {
namespace {

Mesh triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {0, 1, 2}}; }

void expect_refused(const Mesh& mesh, const char* reason) {
  try {
    check(mesh);
    ADD_FAILURE() << "accepted: " << reason;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(reason));
  }
}

TEST(Check, names_the_broken_invariant) {
  EXPECT_NO_THROW(check(triangle()));
  EXPECT_NO_THROW(check(Mesh{}));
  Mesh mesh = triangle();
  mesh.indices.pop_back();
  expect_refused(mesh, "2 indices");
  mesh = triangle();
  mesh.indices[2] = 3;
  expect_refused(mesh, "triangle 0 names vertex 3");
  mesh = triangle();
  mesh.normals.resize(2);
  expect_refused(mesh, "2 normals for 3 positions");
  mesh = triangle();
  mesh.uvs.resize(1);
  expect_refused(mesh, "1 uvs for 3 positions");
  mesh = triangle();
  mesh.positions[1].y = std::numeric_limits<float>::infinity();
  expect_refused(mesh, "position 1 is not finite");
  mesh = triangle();
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, std::numeric_limits<float>::quiet_NaN()}};
  expect_refused(mesh, "normal 2 is not finite");
}

TEST(ComputeNormals, are_the_faces_planes_weighted_by_area) {
  // Two triangles over one edge: area vectors (0, 0, 2) and (1, 0, 0); the shared vertices get
  // their sum.
  Mesh mesh{{{0, 0, 0}, {0, 1, 0}, {-4, 0, 0}, {0, 0, -2}}, {}, {}, {0, 1, 2, 0, 3, 1}};
  compute_normals(mesh);
  const glm::dvec3 shared = glm::normalize(glm::dvec3(2, 0, 4));
  EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[0]) - shared), 0.0, 1e-7);  // float normals
  EXPECT_NEAR(glm::length(glm::dvec3(mesh.normals[1]) - shared), 0.0, 1e-7);
  EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[3], glm::vec3(1, 0, 0));
}

TEST(ComputeNormals, are_finite_where_no_triangle_tells) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {}, {}, {0, 1, 2}};
  compute_normals(mesh);
  EXPECT_NO_THROW(check(mesh));
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.normals[3], glm::vec3(0, 1, 0));
}

TEST(Bounds, hold_the_moved_vertices) {
  const Bounds box = bounds(triangle(), glm::translate(glm::dmat4(1.0), {1e6, 2.0, -3.0}));
  EXPECT_EQ(box.low, glm::dvec3(1e6, 2, -3));
  EXPECT_EQ(box.high, glm::dvec3(1e6 + 1, 3, -3));
}

TEST(Bounds, of_nothing_are_empty_and_merge_to_the_other) {
  const Bounds nothing = bounds(Mesh{});
  EXPECT_TRUE(nothing.empty());
  EXPECT_TRUE(merge(nothing, nothing).empty());
  const Bounds one = bounds(triangle());
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(merge(nothing, one).high, one.high);
  const Bounds both = merge(one, Bounds{glm::dvec3(-2), glm::dvec3(-1)});
  EXPECT_EQ(both.low, glm::dvec3(-2));
  EXPECT_EQ(both.high, glm::dvec3(1, 1, 0));
}

TEST(Transformed, moves_positions_and_turns_normals) {
  const Mesh moved =
      transformed(sphere(1.0), glm::translate(glm::dmat4(1.0), {5, 0, 0}) *
                                   glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 1.0, 0.5)));
  EXPECT_EQ(bounds(moved).low, glm::dvec3(3, -1, -0.5));
  EXPECT_EQ(bounds(moved).high, glm::dvec3(7, 1, 0.5));
  for (std::size_t i = 0; i < moved.positions.size(); ++i) {
    // The gradient of (x/2)² + y² + (2z)² = 1.
    const glm::dvec3 p = glm::dvec3(moved.positions[i]) - glm::dvec3(5, 0, 0);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(p.x / 4.0, p.y, p.z * 4.0));
    EXPECT_NEAR(glm::length(glm::dvec3(moved.normals[i]) - normal), 0.0,
                2e-6);  // float positions at 5
  }
}

TEST(Transformed, by_a_mirror_stays_counter_clockwise_from_outside) {
  const Mesh mirrored =
      transformed(box({1, 2, 3}), glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0)));
  EXPECT_DOUBLE_EQ(volume(mirrored), 6.0);
  EXPECT_EQ(open_edges(mirrored), 0);
  EXPECT_GT(least_normal_agreement(mirrored), 0.99);
}

TEST(Transformed, refuses_what_is_not_affine_or_flattens) {
  glm::dmat4 projective(1.0);
  projective[2].w = -1.0;
  EXPECT_THROW(transformed(triangle(), projective), InputError);
  EXPECT_THROW(transformed(triangle(), glm::scale(glm::dmat4(1.0), {1.0, 0.0, 1.0})), InputError);
  EXPECT_THROW(transformed(triangle(), glm::dmat4(std::numeric_limits<double>::quiet_NaN())),
               InputError);
  EXPECT_NO_THROW(transformed(triangle(), glm::scale(glm::dmat4(1.0), glm::dvec3(1e-6))));
}

TEST(PlaneOf, holds_all_vertices_and_faces_as_the_triangles_do) {
  const glm::dmat4 model = glm::translate(glm::dmat4(1.0), {3, 2, 1}) *
                           glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3));
  const Mesh mesh = plane(4, 2, 3, 5);
  const std::optional<glm::dvec4> found = plane_of(mesh, model);
  ASSERT_TRUE(found);
  EXPECT_NEAR(glm::length(glm::dvec3(*found) - glm::dvec3(model[1])), 0.0, 1e-7);  // float mesh
  EXPECT_NEAR(glm::dot(*found, model[3]), 0.0, 1e-7);

  Mesh turned = mesh;
  std::swap(turned.indices[0], turned.indices[1]);
  turned.indices.resize(3);
  EXPECT_EQ(plane_of(turned), glm::dvec4(0, -1, 0, 0));
}

TEST(PlaneOf, is_exact_far_from_the_origin) {
  const glm::dmat4 model = glm::translate(glm::dmat4(1.0), glm::dvec3(1e6));
  EXPECT_EQ(plane_of(plane(4, 2), model), glm::dvec4(0, 1, 0, -1e6));
}

TEST(PlaneOf, of_a_two_sided_sheet_is_its_plane) {
  Mesh mesh = triangle();
  mesh.indices = {0, 1, 2, 0, 2, 1};
  EXPECT_EQ(plane_of(mesh), glm::dvec4(0, 0, 1, 0));
}

TEST(PlaneOf, is_nothing_for_what_is_not_planar) {
  EXPECT_FALSE(plane_of(box()));
  EXPECT_FALSE(plane_of(Mesh{}));
  EXPECT_FALSE(plane_of(Mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}, {}, {0, 1, 2}}));
  const std::vector<double> bump{0, 0, 0, 0, 1e-4, 0, 0, 0, 0};
  EXPECT_FALSE(plane_of(grid(2, 2, 2, 2, bump)));
}

}  // namespace
}  // namespace shadowlab::scene
