#include "measure/caster_edges.h"

#include <gtest/gtest.h>

#include <memory>

namespace shadowlab::measure {
namespace {

std::size_t sides_of(const scene::Mesh& mesh, glm::dvec4 light) {
  scene::Scene scene;
  scene.objects.emplace_back();
  scene.objects.back().mesh = std::make_shared<scene::Mesh>(mesh);
  scene.objects.back().role = scene::Role::caster;
  std::size_t sides = 0;
  for (const Edge& edge : caster_edges(scene, light)) sides += edge.sides;
  return sides;
}

// Twelve edges and a diagonal of each of six faces. A light that sees one face leaves its four
// edges as the outline, one that sees three leaves six.
TEST(CasterEdges, of_a_box_have_a_side_where_lit_and_unlit_faces_meet) {
  EXPECT_EQ(sides_of(scene::box({1, 1, 1}), {0, 9, 0, 1}), 4u);
  EXPECT_EQ(sides_of(scene::box({1, 1, 1}), {9, 9, 9, 1}), 6u);
  EXPECT_EQ(sides_of(scene::box({1, 1, 1}), {1, 2, 3, 0}), 6u);
}

TEST(CasterEdges, of_triangles_that_run_the_same_way_have_a_side_each) {
  scene::Mesh sheet = scene::plane(2, 2);
  EXPECT_EQ(sides_of(sheet, {0, 9, 0, 1}), 4u);
  std::swap(sheet.indices[0], sheet.indices[1]);
  EXPECT_EQ(sides_of(sheet, {0, 9, 0, 1}), 6u) << "its diagonal is not one surface's";
}

}  // namespace
}  // namespace shadowlab::measure
