#include "shadow/reach.h"

#include <random>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace shadowlab::shadow {
namespace {

struct Setting {
  scene::Bounds bounds;
  glm::dmat4 model;
  glm::dvec4 light;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double unit() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
  glm::dvec3 point() { return {normal_(engine_), normal_(engine_), normal_(engine_)}; }
  Setting setting() {
    Setting s;
    const glm::dvec3 half = glm::abs(point()) + 0.01, center = point();
    s.bounds = {center - half, center + half};
    s.model = glm::rotate(glm::translate(glm::dmat4(1), point()), unit() * 6, point());
    s.model = glm::scale(s.model, glm::abs(point()) + 0.1);
    s.light = {point() * 3.0, unit() < 0.3 ? 0.0 : 1.0};
    return s;
  }

 private:
  std::mt19937 engine_;
  std::normal_distribution<double> normal_;
};

/// Whether the way from `p` to the light meets the box, which in model space is grown by `room`.
bool shadowed(const Setting& s, glm::dvec3 p, double room) {
  const glm::dmat4 to_model = glm::inverse(s.model);
  const glm::dvec3 from(to_model * glm::dvec4(p, 1));
  const glm::dvec4 light = to_model * s.light;
  const glm::dvec3 way = light.w == 0 ? glm::dvec3(light) : glm::dvec3(light) - from;
  double in = 0, out = light.w == 0 ? 1e300 : 1;
  for (int i = 0; i < 3; ++i) {
    const double a = (s.bounds.low[i] - room - from[i]) / way[i],
                 b = (s.bounds.high[i] + room - from[i]) / way[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out;
}

bool inside(const ShadowReach& reach, glm::dvec3 p) {
  for (const glm::dvec4& plane : reach.planes()) {
    if (glm::dot(glm::dvec3(plane), p) + plane.w < 0) return false;
  }
  return true;
}

// The room of 1e-6 is a thousand times what doubles round here, so the two answers differ nowhere
// else than within it.
TEST(ShadowReach, holds_exactly_the_points_whose_way_to_the_light_meets_the_box) {
  Random random(1);
  int in = 0, out = 0;
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random.setting();
    const ShadowReach reach(crate_around(s.bounds, s.model, 1e-9), s.light);
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 p = random.point() * 4.0;
      if (shadowed(s, p, -1e-6)) {
        EXPECT_TRUE(inside(reach, p));
        ++in;
      } else if (!shadowed(s, p, 1e-6)) {
        EXPECT_FALSE(inside(reach, p));
        ++out;
      }
    }
  }
  EXPECT_GT(in, 1000);
  EXPECT_GT(out, 2000);
}

TEST(ShadowReach, is_everything_where_the_light_is_inside_the_box) {
  const Crate crate = crate_around({{-1, -1, -1}, {1, 1, 1}}, glm::dmat4(1), 0.1);
  EXPECT_TRUE(ShadowReach(crate, {0.2, 0.3, 0.1, 1}).planes().empty());
}

TEST(ShadowReach, parts_from_a_box_only_where_none_of_its_points_is_inside) {
  Random random(2);
  int parted = 0;
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random.setting(), other = random.setting();
    const ShadowReach reach(crate_around(s.bounds, s.model, 1e-9), s.light);
    const Crate crate = crate_around(other.bounds, other.model, 1e-9);
    if (!reach.parts_from(crate)) continue;
    ++parted;
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 t(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
      EXPECT_FALSE(inside(
          reach, crate.center + crate.half[0] * t.x + crate.half[1] * t.y + crate.half[2] * t.z));
    }
  }
  EXPECT_GT(parted, 200);
}

TEST(Crate, around_a_flattened_box_has_room_on_every_side) {
  // The model flattens the box into y = 2.
  const glm::dmat4 flat = glm::translate(glm::dmat4(1), glm::dvec3(0, 2, 0)) *
                          glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 3));
  const Hexahedron shape = hexahedron(crate_around({{-1, -1, -1}, {1, 1, 1}}, flat, 0.1));
  for (const glm::dvec4& plane : shape.planes) {
    for (const double y : {1.91, 2.09})
      EXPECT_GT(glm::dot(plane, glm::dvec4(0.99, y, -3.09, 1)), 0);
    EXPECT_LT(glm::dot(plane, glm::dvec4(0, 2, 0, 1)), 3.2);
  }
}

}  // namespace
}  // namespace shadowlab::shadow
