#include "shadow/silhouette.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "casters.h"
#include "scene/exact_sign.h"

namespace shadowlab::shadow {
namespace {

using scene::Adjacency;

glm::dvec4 random_light(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random), random() % 3 == 0 ? 0.0 : 1.0};
}

TEST(Silhouette, of_any_mesh_is_closed_loops) {
  // The boundary of a boundary is zero: as many edges enter a vertex as leave it.
  std::mt19937 random(1);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (int trial = 0; trial < 20; ++trial) {
      std::map<std::uint32_t, int> balance;
      for (const SilhouetteEdge& edge : silhouette(mesh, random_light(random))) {
        balance[edge.a] += static_cast<int>(edge.multiplicity);
        balance[edge.b] -= static_cast<int>(edge.multiplicity);
      }
      for (const auto& [vertex, sum] : balance) ASSERT_EQ(sum, 0);
    }
  }
}

TEST(Silhouette, of_a_box_from_before_a_face_is_that_faces_rim_counter_clockwise) {
  const Adjacency mesh = scene::adjacency(scene::box());
  const auto edges = silhouette(mesh, {0, 0, 5, 1});
  ASSERT_EQ(edges.size(), 4u);
  for (const SilhouetteEdge& edge : edges) {
    const glm::vec3 a = mesh.positions[edge.a], b = mesh.positions[edge.b];
    EXPECT_EQ(edge.multiplicity, 1u);
    EXPECT_EQ(a.z, 0.5f);
    EXPECT_EQ(b.z, 0.5f);
    EXPECT_GT(glm::cross(a, b).z, 0);
  }
}

TEST(Silhouette, of_a_box_with_the_light_in_the_plane_of_a_face_is_that_of_the_lit_faces) {
  const Adjacency mesh = scene::adjacency(scene::box());
  // In the planes of the faces at z = ±0.5, beside the one at x = 0.5: only that one is lit.
  for (const double z : {0.5, -0.5}) EXPECT_EQ(silhouette(mesh, {5, 0, z, 1}).size(), 4u);
  // In the line of an edge, where two faces' planes meet.
  EXPECT_EQ(silhouette(mesh, {5, 0.5, 0.5, 1}).size(), 4u);
}

TEST(Silhouette, of_a_closed_mesh_is_the_same_loops_whether_in_plane_faces_count_or_not) {
  // Row 16: with the light in a face's plane either facing gives closed loops that cast one shadow;
  // they differ by that face's boundary, which the light sees edge on.
  const Adjacency mesh = scene::adjacency(scene::torus(0.6, 0.25, 20, 10));
  std::mt19937 random(2);
  int in_plane = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t t = random() % mesh.triangles.size();
    const auto& [a, b, c] = mesh.triangles[t];
    const glm::dvec4 light(glm::dvec3(mesh.positions[a]) - glm::dvec3(mesh.positions[b]), 0);
    // Unless the double's difference was rounded.
    if (scene::plane_side(mesh.positions[a], mesh.positions[b], mesh.positions[c], light) != 0) {
      continue;
    }
    ++in_plane;
    auto chain = shadow_chain(mesh, light);
    EXPECT_EQ(chain[t], 0);
    const auto without = boundary(mesh, chain);
    chain[t] = 1;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> difference;
    for (const auto& e : boundary(mesh, chain))
      difference[{e.a, e.b}] += static_cast<int>(e.multiplicity);
    for (const auto& e : without) difference[{e.b, e.a}] += static_cast<int>(e.multiplicity);
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) --difference[{from, to}];
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> net;
    for (const auto& [edge, count] : difference) {
      net[std::minmax({edge.first, edge.second})] += edge.first < edge.second ? count : -count;
    }
    for (const auto& [edge, count] : net) EXPECT_EQ(count, 0);
  }
  EXPECT_GT(in_plane, 50);
}

TEST(Silhouette, names_no_edge_at_a_vertex_where_the_light_is) {
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 7) {
      for (const SilhouetteEdge& edge : silhouette(mesh, {glm::dvec3(mesh.positions[v]), 1})) {
        ASSERT_NE(edge.a, v);
        ASSERT_NE(edge.b, v);
      }
    }
  }
}

TEST(Components, lit_faces_suffice_for_closed_ones_seen_from_outside_their_box) {
  const auto parts =
      components(scene::adjacency(joined(scene::box(), moved(scene::quad(), {5, 0, 0}))));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(parts[0].closed);
  EXPECT_TRUE(parts[0].lit_faces_suffice({0, 1, 0, 1}));
  EXPECT_TRUE(parts[0].lit_faces_suffice({0, 1, 0, 2 - 1e-9}));
  EXPECT_FALSE(parts[0].lit_faces_suffice({0, 1, 0, 2}));  // on the face: (0, 0.5, 0)
  EXPECT_FALSE(parts[0].lit_faces_suffice({0.1, 0.2, 0.3, 1}));
  EXPECT_TRUE(parts[0].lit_faces_suffice({0.1, 0.2, 0.3, 0}));
  EXPECT_FALSE(parts[1].lit_faces_suffice({9, 9, 9, 1}));
}

TEST(Components, know_when_they_are_inside_out) {
  const Mesh ball = moved(scene::sphere(), {1000, 2000, 3000});
  EXPECT_FALSE(components(scene::adjacency(ball))[0].inside_out);
  EXPECT_TRUE(components(scene::adjacency(turned_round(ball)))[0].inside_out);
}

}  // namespace
}  // namespace shadowlab::shadow
