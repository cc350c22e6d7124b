#include "shadow/facing.h"

#include <random>

#include <gtest/gtest.h>

#include "casters.h"
#include "core/error.h"
#include "scene/exact_sign.h"

namespace shadowlab::shadow {
namespace {

using scene::Adjacency;

/// Both kinds of facing of all triangles, against the exact sign of each.
void expect_exact(const Adjacency& mesh, glm::dvec4 light) {
  const FacingPlanes planes(mesh.positions, mesh.triangles);
  std::vector<std::int8_t> lit(mesh.triangles.size()), signs(lit.size());
  planes.lit(light, 0, lit);
  planes.signs(light, 0, signs);
  for (std::size_t t = 0; t < lit.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const int exact =
        scene::plane_side(mesh.positions[a], mesh.positions[b], mesh.positions[c], light);
    ASSERT_EQ(signs[t], exact) << "triangle " << t;
    ASSERT_EQ(lit[t], exact > 0 ? 1 : 0) << "triangle " << t;
  }
}

std::vector<Caster> casters_and_needles() {
  std::vector<Caster> all = casters();
  all.push_back({"needles", needles()});
  return all;
}

TEST(FacingPlanes, agree_with_the_exact_sign_for_lights_anywhere) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const Caster& caster : casters_and_needles()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (int trial = 0; trial < 30; ++trial) {
      const double scale = std::pow(10.0, 3 * normal(random));
      const glm::dvec3 p(normal(random), normal(random), normal(random));
      expect_exact(mesh, {p * scale, 1});
      expect_exact(mesh, {p * scale, 0});
      expect_exact(mesh, {p, std::abs(normal(random)) * scale});
    }
  }
}

TEST(FacingPlanes, agree_with_the_exact_sign_for_lights_within_an_ulp_of_a_plane) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> weight(-2, 2);
  for (const Caster& caster : casters_and_needles()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (int trial = 0; trial < 60; ++trial) {
      const auto& [a, b, c] = mesh.triangles[random() % mesh.triangles.size()];
      const double u = weight(random), v = weight(random);
      const glm::dvec3 p = glm::dvec3(mesh.positions[a]) * (1 - u - v) +
                           glm::dvec3(mesh.positions[b]) * u + glm::dvec3(mesh.positions[c]) * v;
      expect_exact(mesh, {p, 1});
      expect_exact(mesh, {glm::dvec3(glm::vec3(p)), 1});
      // As far along a short edge as along a long one.
      const glm::dvec3 edge = glm::dvec3(mesh.positions[c]) - glm::dvec3(mesh.positions[b]);
      expect_exact(mesh, {p + glm::normalize(edge) * u, 1});
      expect_exact(mesh, {glm::dvec3(mesh.positions[a]), 1});
      expect_exact(mesh, {glm::dvec3(mesh.positions[a]) - glm::dvec3(mesh.positions[b]), 0});
    }
  }
}

TEST(FacingPlanes, agree_with_the_exact_sign_far_from_the_origin_and_at_all_scales) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double scale : {1e-40, 1e-20, 1.0, 1e20, 1e37}) {
    for (const double offset : {0.0, 1.0, 1e3, 1e6}) {
      if (scale * offset > 1e37) continue;  // no float
      Mesh mesh = bare(scene::torus());
      for (glm::vec3& p : mesh.positions) p = glm::vec3((glm::dvec3(p) + offset) * scale);
      const Adjacency built = scene::adjacency(mesh);
      SCOPED_TRACE(scale);
      SCOPED_TRACE(offset);
      for (int trial = 0; trial < 8; ++trial) {
        const glm::dvec3 p(normal(random), normal(random), normal(random));
        expect_exact(built, {(p + offset) * scale, 1});
        expect_exact(built, {p * 1e-300, 0});
        expect_exact(built, {p * 1e300, 1e-300});
        expect_exact(built, {(p + offset) * scale * 1e-200, 1e-200});
      }
    }
  }
}

TEST(FacingPlanes, of_a_part_are_those_of_the_whole) {
  const Adjacency mesh = scene::adjacency(scene::sphere(1, 40, 20));
  const FacingPlanes planes(mesh.positions, mesh.triangles);
  std::vector<std::int8_t> whole(mesh.triangles.size()), part(100);
  planes.signs({3, 1, 2, 1}, 0, whole);
  planes.signs({3, 1, 2, 1}, 777, part);
  EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + 777));
}

TEST(FacingPlanes, move_a_light_off_the_triangles_that_it_lies_on_and_no_other) {
  const Adjacency mesh = scene::adjacency(scene::tetrahedron(0.6));
  const FacingPlanes planes(mesh.positions, mesh.triangles);
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const glm::dvec3 normal = glm::normalize(glm::cross(q - p, r - p));
    const auto height = [&](glm::dvec4 light) { return glm::dot(normal, glm::dvec3(light) - p); };
    for (const glm::dvec3 at : {(p + q + r) / 3.0, (p + q) * 0.5, p}) {
      for (const double off : {0.0, 1e-9, -1e-9, 1e-7, -1e-7}) {
        const glm::dvec4 light(at + normal * off, 1), moved = planes.beside(light);
        // Off a corner it may come to be beside a triangle, where its plane is as near as it likes.
        if (at != p && off != 0) {
          EXPECT_GT(std::abs(height(moved)), 1e-6) << off;
        }
        EXPECT_LT(glm::distance(moved, light), 3e-5) << off;
        if (off != 0 && at == (p + q + r) / 3.0) {
          EXPECT_EQ(height(moved) > 0, off > 0);
        }
      }
    }
    // In its plane beside it, above it, and at infinity in its plane.
    for (const glm::dvec4 light :
         {glm::dvec4(p + (p - q), 1), glm::dvec4(p + normal * 1e-4, 1), glm::dvec4(p - q, 0)})
      EXPECT_EQ(planes.beside(light), light);
  }
}

TEST(Light, that_is_no_place_is_refused_and_a_negative_w_is_the_same_point) {
  EXPECT_THROW(normalized_light({0, 0, 0, 0}), InputError);
  EXPECT_THROW(normalized_light({std::nan(""), 0, 0, 1}), InputError);
  EXPECT_THROW(normalized_light({0, 0, 0, 1.0 / 0.0}), InputError);
  EXPECT_EQ(normalized_light({1, -2, 3, -1}), glm::dvec4(-1, 2, -3, 1));
  EXPECT_EQ(normalized_light({0, 0, 0, 1}), glm::dvec4(0, 0, 0, 1));
}

TEST(Light, in_model_space_is_where_the_object_sees_it) {
  glm::dmat4 model(2.0);  // twice as large
  model[3] = {1, 2, 3, 1};
  EXPECT_EQ(light_in_model_space(model, {5, 2, 3, 1}), glm::dvec4(2, 0, 0, 1));
  EXPECT_EQ(light_in_model_space(model, {0, 4, 0, 0}), glm::dvec4(0, 2, 0, 0));
  model[0] = glm::dvec4(0);
  EXPECT_THROW(light_in_model_space(model, {1, 1, 1, 1}), InputError);
}

}  // namespace
}  // namespace shadowlab::shadow
