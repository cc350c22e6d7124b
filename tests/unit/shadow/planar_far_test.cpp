// Planar shadows in a world far from its origin: the table of planar.h.
#include <algorithm>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "shadow/planar.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

dvec3 position(dvec4 v) { return dvec3(v) / v.w; }
dvec3 image(const dmat4& m, dvec3 v) { return position(m * dvec4(v, 1.0)); }

struct Errors {
  double collapsed_float = 0, collapsed = 0, factors = 0, factors_float = 0;
};

/// The largest error of a shadow's position in eye space, the scene being moved by `offset`.
Errors errors_at(double offset) {
  const dvec3 move(offset, -0.5 * offset, 0.75 * offset);
  const dvec3 normal = glm::normalize(dvec3(1, 4, 2));
  const dvec3 eye(3, 5, 9), light(2, 7, 3);
  const auto view_at = [&](dvec3 by) { return glm::lookAt(eye + by, by, dvec3(0, 1, 0)); };
  const dmat4 view = view_at(move), model = glm::translate(dmat4(1.0), move);
  const dvec4 plane(normal, -glm::dot(normal, move));
  const dmat4 m = planar(plane, dvec4(light + move, 1.0));
  const dmat4 near = model_view(planar_near(plane, dvec4(light + move, 1.0), move), view, model);
  const glm::mat4 view_f(view), model_f(model), m_f(m), near_f(near);
  const auto of = [](const glm::vec4& v) { return dvec3(v) / static_cast<double>(v.w); };

  Errors worst;
  for (int i = 0; i < 125; ++i) {
    const dvec3 v(0.5 * (i % 5) - 1.0, 2.0 + 0.25 * (i / 5 % 5), 0.5 * (i / 25) - 1.0);
    const glm::vec4 v_f(glm::vec3(v), 1.0f);
    // The ray by hand, at the origin.
    const double light_height = glm::dot(normal, light), height = glm::dot(normal, v);
    const dvec3 hit = v + (v - light) * (height / (light_height - height));
    const dvec3 truth = dvec3(view_at(dvec3(0)) * dvec4(hit, 1.0));
    const auto error = [&](dvec3 found) { return glm::length(found - truth); };
    worst.collapsed_float =
        std::max(worst.collapsed_float, error(of(view_f * (m_f * (model_f * v_f)))));
    worst.collapsed = std::max(worst.collapsed, error(position(view * m * model * dvec4(v, 1.0))));
    worst.factors = std::max(worst.factors, error(position(near * dvec4(v, 1.0))));
    worst.factors_float = std::max(worst.factors_float, error(of(near_f * v_f)));
  }
  return worst;
}

TEST(Planar, keeps_its_place_in_a_world_far_from_its_origin) {
  struct Row {
    double offset;
    Errors most;
  };
  // The header's table. Factors: eye, light and plane are themselves rounded to 1e-16 of the
  // offset. To float: a scene of ten units. Double: the entries' size, offset², times 1e-17.
  const Row table[] = {{0.0, {2e-6, 6e-15, 6e-15, 2e-6}},
                       {1e3, {1e-2, 2e-11, 3e-13, 2e-6}},
                       {1e5, {2e2, 1e-7, 2e-11, 2e-6}},
                       {1e6, {1e4, 1e-5, 2e-10, 2e-6}}};
  for (const auto& [offset, most] : table) {
    const Errors errors = errors_at(offset);
    EXPECT_LE(errors.collapsed_float, most.collapsed_float) << offset;
    EXPECT_LE(errors.collapsed, most.collapsed) << offset;
    EXPECT_LE(errors.factors, most.factors) << offset;
    EXPECT_LE(errors.factors_float, most.factors_float) << offset;
  }
  // The matrix in floats leaves the picture: by pixels at a kilometre, by the whole scene at a
  // hundred.
  EXPECT_GT(errors_at(1e3).collapsed_float, 1e-3);
  EXPECT_GT(errors_at(1e5).collapsed_float, 10.0);
}

TEST(PlanarNear, is_planar_about_a_point_of_the_plane) {
  const dvec4 plane(1, 2, 2, -3);
  for (const dvec4& light : {dvec4(3, 5, 7, 1), dvec4(1, 2, -1, 0)}) {
    const PlanarProjection p = planar_near(plane, light, {4, 1, -2});
    EXPECT_NEAR(glm::dot(plane, dvec4(p.origin, 1.0)), 0.0, 1e-15);
    const dvec3 expected = image(planar(plane, light), {2, 3, 1});
    const dvec3 found = image(p.local, dvec3(2, 3, 1) - p.origin) + p.origin;
    EXPECT_LT(glm::length(found - expected), 1e-14);  // order-one arithmetic
  }
}

}  // namespace
}  // namespace shadowlab::shadow
