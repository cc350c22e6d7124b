#include "shadow/back.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {
namespace {

TEST(Back, is_of_a_box_and_of_nothing_else) {
  EXPECT_TRUE(fills_its_box(scene::box({1, 2, 3})));
  EXPECT_FALSE(fills_its_box(scene::sphere()));
  EXPECT_FALSE(fills_its_box(scene::plane(1, 1)));
  scene::Mesh open = scene::box();
  // One triangle twice in place of the other half of its face.
  for (std::size_t k = 0; k < 3; ++k) open.indices[k] = open.indices[3 + k];
  EXPECT_FALSE(fills_its_box(open));
}

TEST(Back, is_of_a_box_whose_every_triangle_is_turned_out) {
  EXPECT_TRUE(is_solid_box(scene::box({1, 2, 3})));
  scene::Mesh mesh = scene::box();
  std::swap(mesh.indices[30], mesh.indices[31]);
  EXPECT_TRUE(fills_its_box(mesh));
  EXPECT_FALSE(is_solid_box(mesh));
}

// A box of unit size whose middle is at z, seen from the origin along -z, the near plane at 0.1.
bool hidden_at(double z, const glm::dmat4& model = glm::dmat4(1)) {
  scene::Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  camera.near = 0.1;
  const glm::dmat4 place = glm::translate(glm::dmat4(1), {0, 0, z});
  return hides_its_back(scene::bounds(scene::box()),
                        camera.projection(1) * camera.view() * place * model);
}

TEST(Back, is_hidden_where_the_near_plane_does_not_cut_the_box) {
  EXPECT_TRUE(hidden_at(-5));
  EXPECT_TRUE(hidden_at(-0.61));
  EXPECT_FALSE(hidden_at(-0.59)) << "cut, so that one looks into it";
  EXPECT_FALSE(hidden_at(0)) << "around the eye";
  EXPECT_FALSE(hidden_at(5)) << "behind it";
}

TEST(Back, is_not_hidden_under_a_mirror) {
  EXPECT_TRUE(hidden_at(-5, glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(1, 2, 3))));
  EXPECT_FALSE(hidden_at(-5, glm::scale(glm::dmat4(1), {-1, 1, 1})));
  EXPECT_FALSE(hidden_at(-5, glm::scale(glm::dmat4(1), {1, 0, 1}))) << "flat";
}

}  // namespace
}  // namespace shadowlab::shadow
