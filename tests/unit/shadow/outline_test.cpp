#include "shadow/outline.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "casters.h"
#include "shadow/volume.h"
#include "winding.h"

namespace shadowlab::shadow {
namespace {

using scene::Adjacency;

glm::dvec4 random_point(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  return {coordinate(random), coordinate(random), coordinate(random), 1};
}

bool outside(const scene::Bounds& box, glm::dvec4 p) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < box.low[i] || p[i] > box.high[i]) return true;
  }
  return false;
}

std::vector<glm::dvec4> positions_of(const VolumeBuilder& builder) {
  return {builder.vertices().begin(), builder.vertices().end()};
}

TEST(Outline, is_crossed_as_often_as_the_triangles_that_count) {
  std::mt19937 random(1);
  int crossed = 0, bounded = 0;
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    VolumeBuilder builder(caster.mesh);
    const auto positions = positions_of(builder);
    const scene::Bounds box = scene::bounds(caster.mesh);
    for (int trial = 0; trial < 40; ++trial) {
      glm::dvec4 light = random_point(random, 4);
      if (trial % 4 == 0) light.w = 0;
      if (light.w != 0 && !outside(box, light)) continue;
      const auto faces = builder.flat(light, Filling::faces).indices;
      const std::vector counted(faces.begin(), faces.end());
      const auto [outline, layers, offset] = builder.flat(light, Filling::outline);
      ASSERT_EQ(offset, 0);
      for (int i = 0; i < 60; ++i) {
        // From beyond the caster, so that many a segment passes through it.
        const glm::dvec4 through = random_point(random, 0.8);
        const glm::dvec4 p =
            light.w == 0
                ? through - light * 3.0
                : glm::dvec4(glm::dvec3(light) + 3.0 * (glm::dvec3(through) - glm::dvec3(light)),
                             1);
        if (!outside(box, p)) continue;
        const auto expected = winding(positions, counted, p, light);
        const auto found = winding(positions, outline, p, light);
        if (!expected || !found) continue;
        ASSERT_EQ(*found, *expected);
        if (layers) {
          ASSERT_LE(*found, static_cast<int>(*layers));
        }
        bounded += layers ? 1 : 0;
        crossed += *expected != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(crossed, 2000);
  EXPECT_GT(bounded, 2000);
}

// In the hole of a torus, in a corner of a box's box, inside a solid: the same number is missing in
// all directions.
TEST(Outline, around_a_light_counts_as_the_triangles_but_for_its_offset) {
  std::mt19937 random(4);
  int moved = 0, outlines = 0;
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    VolumeBuilder builder(caster.mesh);
    const auto positions = positions_of(builder);
    const scene::Bounds box = scene::bounds(caster.mesh);
    std::uniform_real_distribution<double> inside(0.02, 0.98);
    for (int trial = 0; trial < 30; ++trial) {
      const glm::dvec3 in_box(inside(random), inside(random), inside(random));
      const glm::dvec4 light(box.low + in_box * (box.high - box.low), 1);
      const auto faces = builder.flat(light, Filling::faces).indices;
      const std::vector counted(faces.begin(), faces.end());
      const Flat found = builder.flat(light, Filling::around);
      outlines += found.indices.size() < counted.size();
      moved += found.offset != 0;
      for (int i = 0; i < 40; ++i) {
        const glm::dvec4 p = random_point(random, 6);
        if (!outside(box, p)) continue;
        const auto expected = winding(positions, counted, p, light);
        const auto around = winding(positions, found.indices, p, light);
        if (expected && around) {
          ASSERT_EQ(*around + found.offset, *expected);
          ASSERT_LE(std::abs(*expected), static_cast<int>(found.layers.value_or(1000)));
        }
      }
    }
  }
  EXPECT_GT(outlines, 50);
  EXPECT_GT(moved, 50);
}

TEST(Outline, of_faces_counts_every_triangle_between_a_point_and_the_light_where_all_are_turned) {
  std::mt19937 random(2);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    VolumeBuilder builder(mesh);
    const auto positions = positions_of(builder);
    for (int trial = 0; trial < 10; ++trial) {
      const glm::dvec4 light = random_point(random, 3);
      const auto faces = builder.flat(light, Filling::faces, {.faces = Faces::turned}).indices;
      for (int i = 0; i < 40; ++i) {
        const glm::dvec4 p = random_point(random, 3);
        const auto expected = blockers(mesh, p, light);
        const auto found = winding(positions, faces, p, light);
        if (expected && found) {
          ASSERT_EQ(*found, *expected);
        }
      }
    }
  }
}

TEST(Outline, has_far_fewer_triangles_than_the_caster) {
  VolumeBuilder builder(scene::torus(0.42, 0.13));
  EXPECT_LE(builder.flat({0, 5, 1, 1}, Filling::outline).indices.size() / 3, 2u * 48u + 24u);
  EXPECT_EQ(builder.triangle_count(), 2u * 48u * 24u);
}

TEST(Outline, of_a_mirrored_caster_is_turned) {
  VolumeBuilder builder(scene::box());
  for (const Filling filling : {Filling::outline, Filling::faces}) {
    const auto kept = builder.flat({0, 0, 5, 1}, filling).indices;
    const std::vector before(kept.begin(), kept.end());
    const auto after =
        builder.flat({0, 0, 5, 1}, filling, {.handedness = Handedness::mirrored}).indices;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); i += 3) {
      EXPECT_EQ(after[i], before[i + 1]);
      EXPECT_EQ(after[i + 1], before[i]);
      EXPECT_EQ(after[i + 2], before[i + 2]);
    }
  }
}

// A floor y = 0 of 4 by 4, and a unit box over its middle.
const glm::dvec4 floor_plane{0, 1, 0, 0};
const Placed floor_box{{{-2, 0, -2}, {2, 0, 2}}, glm::dmat4(1)};
Placed unit_box(glm::dvec3 at) {
  glm::dmat4 model(1);
  model[3] = glm::dvec4(at, 1);
  return {{glm::dvec3(-0.5), glm::dvec3(0.5)}, model};
}

TEST(Outline, is_what_fills_a_shadow_where_neither_light_nor_plane_is_in_the_caster_s_box) {
  EXPECT_EQ(filling(unit_box({0, 1, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::outline);
  EXPECT_EQ(filling(unit_box({0, 0.5, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::outline)
      << "it stands on the floor";
  EXPECT_EQ(filling(unit_box({0, 0.4, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::faces)
      << "the floor cuts it";
  EXPECT_EQ(filling(unit_box({0, 1, 0}), {0.2, 1.2, 0, 1}, floor_plane, floor_box), Filling::around)
      << "the light is in it";
  EXPECT_EQ(filling(unit_box({0, 1, 0}), {1, 2, 0, 0}, floor_plane, floor_box), Filling::outline);
}

// Coordinates of 1e5 to 1e6 have doubles' room for a billionth: 0.1 of a metre is no rounding.
TEST(Outline, is_cut_by_the_floor_as_well_where_the_world_is_far_from_its_origin) {
  for (const double away : {0.0, 1e3, 4e5, 1e6}) {
    const glm::dvec3 offset = away * glm::dvec3(-0.7, 0.75, 0.1);
    glm::dmat4 floor(1);
    floor[3] = glm::dvec4(offset, 1);
    const Placed box{floor_box.bounds, floor};
    const glm::dvec4 plane(0, 1, 0, -offset.y), light(offset + glm::dvec3(0, 4, 0), 1);
    const auto filled = [&](double height) {
      return filling(unit_box(offset + glm::dvec3(0, height, 0)), light, plane, box);
    };
    EXPECT_EQ(filled(0.5), Filling::outline) << "it stands on the floor, " << away << " away";
    EXPECT_EQ(filled(0.4), Filling::faces) << "the floor cuts it, " << away << " away";
    EXPECT_EQ(filled(0.499), Filling::faces) << "the floor cuts it, " << away << " away";
  }
}

TEST(Outline, is_nothing_where_a_shadow_cannot_meet_the_receiver) {
  EXPECT_EQ(filling(unit_box({0, -1, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::none)
      << "below the floor";
  EXPECT_EQ(filling(unit_box({0, 5, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::none)
      << "above the light";
  EXPECT_EQ(filling(unit_box({6, 1, 0}), {0, 4, 0, 1}, floor_plane, floor_box), Filling::none)
      << "beyond the floor's end";
  EXPECT_EQ(filling(unit_box({0, 1, 0}), {5, 0, 0, 1}, floor_plane, floor_box), Filling::none)
      << "the light in the floor's plane";
}

TEST(Outline, is_never_nothing_where_a_point_of_the_receiver_is_hidden) {
  std::mt19937 random(3);
  const scene::Mesh ball = scene::sphere(0.5, 8, 6);
  const Adjacency mesh = scene::adjacency(ball);
  int nothing = 0;
  for (int trial = 0; trial < 300; ++trial) {
    glm::dmat4 model(1);
    model[3] = random_point(random, 3);
    glm::dvec4 light = random_point(random, 4);
    if (trial % 3 == 0) light.w = 0;
    if (filling({scene::bounds(ball), model}, light, floor_plane, floor_box) != Filling::none)
      continue;
    ++nothing;
    for (int i = 0; i < 100; ++i) {
      glm::dvec4 p = random_point(random, 2);
      p.y = 0;
      const glm::dmat4 back = glm::inverse(model);
      EXPECT_EQ(blockers(mesh, back * p, back * light).value_or(0), 0);
    }
  }
  EXPECT_GT(nothing, 50);
}

TEST(LoopFilling, has_the_loops_for_its_boundary) {
  std::mt19937 random(4);
  LoopFilling filling;
  for (int trial = 0; trial < 200; ++trial) {
    // Random closed walks, that may meet and share edges.
    std::vector<LoopFilling::Edge> edges;
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    for (std::uint32_t walk = 0, walks = 1 + below(3); walk < walks; ++walk) {
      const std::uint32_t length = 2 + below(12);
      std::vector<std::uint32_t> vertices(length);
      for (auto& v : vertices) v = below(20);
      for (std::uint32_t i = 0; i < length; ++i) {
        if (vertices[i] != vertices[(i + 1) % length])
          edges.push_back({vertices[i], vertices[(i + 1) % length]});
      }
    }
    std::vector<std::uint32_t> out(3 * edges.size());
    const auto* end = filling.append(edges, 20, out.data());
    std::map<std::array<std::uint32_t, 2>, int> boundary;
    const auto add = [&](std::uint32_t a, std::uint32_t b, int by) {
      if (a != b) boundary[{std::min(a, b), std::max(a, b)}] += a < b ? by : -by;
    };
    for (const auto& [a, b] : edges) add(a, b, -1);
    for (const auto* t = out.data(); t != end; t += 3) {
      add(t[0], t[1], 1);
      add(t[1], t[2], 1);
      add(t[2], t[0], 1);
    }
    for (const auto& [edge, sum] : boundary) ASSERT_EQ(sum, 0);
  }
}

TEST(LoopFilling, of_n_vertices_is_n_minus_two_triangles_of_little_length) {
  constexpr std::uint32_t n = 256;
  std::vector<LoopFilling::Edge> circle;
  for (std::uint32_t i = 0; i < n; ++i) circle.push_back({i, (i + 1) % n});
  std::vector<std::uint32_t> out(3 * n);
  LoopFilling filling;
  const auto* end = filling.append(circle, n, out.data());
  EXPECT_EQ(end - out.data(), 3 * (n - 2));
  const auto at = [](std::uint32_t i) {
    return glm::dvec2(std::cos(2 * std::numbers::pi * i / n),
                      std::sin(2 * std::numbers::pi * i / n));
  };
  double perimeters = 0;
  for (const auto* t = out.data(); t != end; t += 3) {
    for (int k = 0; k < 3; ++k) perimeters += glm::distance(at(t[k]), at(t[(k + 1) % 3]));
  }
  // Each of log2 n rounds adds twice the circle's length at most: its chords and their cuts.
  EXPECT_LT(perimeters, 2 * 2 * std::numbers::pi * 8);
}

}  // namespace
}  // namespace shadowlab::shadow
