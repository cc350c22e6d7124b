#include "shadow/volume.h"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "casters.h"
#include "core/error.h"
#include "shadow/volume_lecture.h"
#include "winding.h"

namespace shadowlab::shadow {
namespace {

using scene::Adjacency;

glm::dvec4 random_point(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  return {coordinate(random), coordinate(random), coordinate(random), 1};
}

/// Through memory: GCC 12 forgets the rounding of a double to float and back when it vectorizes
/// straight-line code.
glm::dvec3 in_float(glm::dvec3 p) {
  volatile float x = static_cast<float>(p.x), y = static_cast<float>(p.y),
                 z = static_cast<float>(p.z);
  return {x, y, z};
}

std::vector<glm::dvec4> extruded_vertices(const VolumeBuilder& builder, glm::dvec4 light) {
  std::vector<glm::dvec4> positions;
  for (const glm::vec4& v : builder.vertices()) {
    positions.push_back(v.w != 0 ? glm::dvec4(v) : extruded(glm::dvec3(v), light));
  }
  return positions;
}

/// Counts the volume at `points` points and holds each count against the segment to the light:
/// `turned` counts are the number of triangles in the way; automatic ones are positive where there
/// is one, else 0, and never more.
void expect_counts(const Adjacency& mesh, glm::dvec4 light, int points, unsigned seed) {
  std::mt19937 random(seed);
  VolumeBuilder builder(mesh);
  const auto positions = extruded_vertices(builder, light);
  const auto copy = [](const VolumeIndices& v) { return std::vector(v.all.begin(), v.all.end()); };
  const auto automatic = copy(builder.build(light));
  const auto turned = copy(builder.build(light, {.faces = Faces::turned}));
  // A point that nothing hides from the light, to count from.
  std::optional<glm::dvec4> open;
  for (int trial = 0; trial < 1000 && !open; ++trial) {
    const double near = std::pow(0.7, trial % 40);
    const glm::dvec4 q = light.w == 0 ? random_point(random, 3) + light * 50.0
                                      : light + random_point(random, near) * glm::dvec4(1, 1, 1, 0);
    if (blockers(mesh, q, light) == 0) open = q;
  }
  ASSERT_TRUE(open);
  int told = 0;
  for (int i = 0; i < points; ++i) {
    const glm::dvec4 p = random_point(random, 1.5);
    const auto blocked = blockers(mesh, p, light);
    const auto all = winding(positions, turned, p, *open);
    const auto some = winding(positions, automatic, p, *open);
    if (!blocked || !all || !some) continue;
    ++told;
    ASSERT_EQ(*all, *blocked);
    ASSERT_GE(*some, 0);
    ASSERT_LE(*some, *blocked);
    ASSERT_EQ(*some > 0, *blocked > 0);
  }
  // Points too close to tell are a matter of 1e-10 of the space.
  EXPECT_GE(told, points * 99 / 100);
}

TEST(Volume, of_any_caster_holds_a_point_where_a_triangle_hides_the_light) {
  std::mt19937 random(1);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (unsigned trial = 0; trial < 4; ++trial) {
      expect_counts(mesh, random_point(random, 3), 200, trial);
      expect_counts(mesh, random_point(random, 0.8), 200, trial);
      expect_counts(mesh, random_point(random, 3) * glm::dvec4(1, 1, 1, 0), 200, trial);
    }
  }
}

TEST(Volume, is_right_with_the_light_in_the_plane_of_triangles) {
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    const auto& [a, b, c] = mesh.triangles[mesh.triangles.size() / 2];
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]);
    expect_counts(mesh, {p + (p - q), 1}, 50, 1);
    expect_counts(mesh, {p - q, 0}, 50, 2);
  }
  // In four planes of a box at once.
  const Adjacency box = scene::adjacency(scene::box());
  for (const double z : {0.5, 0.0}) expect_counts(box, {3, 0.5, z, 1}, 500, 3);
  expect_counts(box, {1, 0, 0, 0}, 500, 4);
}

TEST(Volume, is_right_with_the_light_on_a_vertex_an_edge_and_a_face) {
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    const auto& [a, b, c] = mesh.triangles[mesh.triangles.size() / 3];
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    expect_counts(mesh, {p, 1}, 50, 1);
    // Beside the edge and the face by a float's rounding: nearer than that `winding` cannot tell.
    expect_counts(mesh, {in_float((p + q) * 0.5), 1}, 50, 2);
    expect_counts(mesh, {in_float(p * 0.5 + q * 0.25 + r * 0.25), 1}, 50, 3);
  }
  const Adjacency box = scene::adjacency(scene::box());
  expect_counts(box, {0.5, 0.5, 0.25, 1}, 500, 4);
  expect_counts(box, {0.5, 0.125, 0.25, 1}, 500, 5);
}

TEST(Volume, never_refers_to_a_direction_of_zero) {
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 11) {
      const VolumeMesh built = volume(mesh, {glm::dvec3(mesh.positions[v]), 1});
      for (const std::uint32_t i : built.indices) ASSERT_NE(built.positions[i], glm::dvec4(0));
    }
  }
}

TEST(Volume, of_nested_shells_counts_each_of_them) {
  for (const int count : {1, 255, 256, 300}) {
    const Adjacency mesh = scene::adjacency(shells(count));
    for (const glm::dvec4& light : {glm::dvec4(1000, 2000, 1500, 1), glm::dvec4(1, 2, 1.5, 0)}) {
      const VolumeMesh built = volume(mesh, light);
      const glm::dvec4 outside(900, 1900, 1600, 1);
      EXPECT_EQ(winding(built.positions, built.indices, {0.1, 0.2, 0.3, 1}, outside), count);
      // Behind them all, in front of them all.
      EXPECT_EQ(winding(built.positions, built.indices, {-1001, -2002, -1503, 1}, outside), count);
      EXPECT_EQ(winding(built.positions, built.indices, {901, 1801, 1351, 1}, outside), 0);
    }
  }
}

TEST(Volume, does_not_change_with_triangles_that_have_no_area) {
  const Mesh ball = bare(scene::sphere(0.8, 16, 9));
  Mesh more = ball;
  for (std::uint32_t i = 0; i < 90; i += 3) {
    const std::uint32_t a = ball.indices[i], b = ball.indices[i + 1];
    const auto middle = static_cast<std::uint32_t>(more.positions.size());
    // Halves of coordinates are exact, and so is their sum where exponents are near.
    more.positions.push_back(ball.positions[a]);
    more.indices.insert(more.indices.end(), {a, b, b, a, a, a, a, middle, b});
  }
  more.positions.insert(more.positions.end(), {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}});
  const auto last = static_cast<std::uint32_t>(more.positions.size());
  more.indices.insert(more.indices.end(), {last - 3, last - 2, last - 1});
  VolumeBuilder plain(ball), odd(more);
  for (const glm::dvec4& light : {glm::dvec4(1, 2, 3, 1), glm::dvec4(1, -2, 0.5, 0)}) {
    const auto a = plain.build(light), b = odd.build(light);
    EXPECT_TRUE(std::equal(a.all.begin(), a.all.end(), b.all.begin(), b.all.end()));
  }
}

TEST(Volume, of_a_closed_caster_has_half_its_triangles_in_each_cap_and_single_sides) {
  VolumeBuilder box(scene::box());
  const auto built = box.build({0, 0, 5, 1});
  EXPECT_EQ(built.sides.size(), 4u * 6);
  EXPECT_EQ(built.front_cap.size(), 2u * 3);
  EXPECT_EQ(built.back_cap.size(), 2u * 3);
  EXPECT_EQ(built.all.size(), built.sides.size() + 12);
  EXPECT_EQ(box.build({0, 0, 5, 1}, {.caps = Caps::none}).all.size(), 24u);
  // To a point at infinity: triangles, and no back cap.
  const auto far = box.build({0, 0, 5, 0});
  EXPECT_EQ(far.sides.size(), 4u * 3);
  EXPECT_EQ(far.front_cap.size(), 6u);
  EXPECT_TRUE(far.back_cap.empty());
  const auto near = box.build({0, 0, 5, 0}, {.reach = Reach::finite});
  EXPECT_EQ(near.sides.size(), 4u * 6);
  EXPECT_EQ(near.back_cap.size(), 6u);
}

TEST(Volume, sides_are_the_silhouette_as_often_as_it_counts) {
  std::mt19937 random(5);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    VolumeBuilder builder(mesh);
    for (int trial = 0; trial < 20; ++trial) {
      const glm::dvec4 light = random_point(random, 2);
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected, got;
      for (const SilhouetteEdge& e : silhouette(mesh, light)) expected[{e.a, e.b}] = e.multiplicity;
      const auto sides = builder.build(light).sides;
      for (std::size_t i = 0; i < sides.size(); i += 6) {
        ++got[{sides[i + 1] / 2, sides[i] / 2}];
        ASSERT_EQ(sides[i + 2], sides[i + 1] + 1);
        ASSERT_EQ(sides[i + 5], sides[i] + 1);
      }
      ASSERT_EQ(got, expected);
    }
  }
}

TEST(Volume, for_a_mirroring_model_is_turned) {
  const Mesh teapot = bare(scene::teapot(1, 3));
  VolumeBuilder builder(teapot);
  const glm::dvec4 light(2, 3, 1, 1), open(2, 3.1, 1, 1), hidden(-0.2, -0.3, -0.1, 1);
  const auto positions = extruded_vertices(builder, light);
  const auto kept = winding(positions, builder.build(light).all, hidden, open);
  const auto mirrored = winding(
      positions, builder.build(light, {.handedness = Handedness::mirrored}).all, hidden, open);
  ASSERT_TRUE(kept && mirrored);
  EXPECT_GT(*kept, 0);
  EXPECT_EQ(*mirrored, -*kept);
}

TEST(Volume, to_a_distance_ends_there) {
  const Adjacency box = scene::adjacency(scene::box());
  for (const glm::dvec4& light : {glm::dvec4(0, 0, 100, 1), glm::dvec4(0, 0, 1, 0)}) {
    const VolumeMesh built = volume(box, light, Caps::both, 10);
    const auto at = [&](double z) {
      return winding(built.positions, built.indices, {0.1, 0.2, z, 1}, {0.1, 0.2, 50, 1});
    };
    EXPECT_EQ(at(0.6), 0);
    EXPECT_EQ(at(-5), 1);
    EXPECT_EQ(at(-9.4), 1);  // the lit face is at 0.5
    EXPECT_EQ(at(-9.6), 0);
  }
  EXPECT_THROW(volume(box, {0, 0, 1, 0}, Caps::both, 0), InputError);
  EXPECT_THROW(volume(box, {0, 0, 1, 0}, Caps::both, std::nan("")), InputError);
}

TEST(Volume, of_nothing_is_nothing) {
  VolumeBuilder builder(Mesh{});
  EXPECT_TRUE(builder.build({1, 2, 3, 1}).all.empty());
}

/// How often each undirected edge has a side, in the direction of lesser to greater vertex.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> net_sides(
    std::span<const std::uint32_t> sides) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> net;
  for (std::size_t i = 0; i < sides.size(); i += 6) {
    net[std::minmax({sides[i], sides[i + 1]})] += sides[i + 1] < sides[i] ? 1 : -1;
  }
  std::erase_if(net, [](const auto& entry) { return entry.second == 0; });
  return net;
}

TEST(LectureLoop, stages_are_nothing_then_right_but_twice_too_many_then_the_silhouette) {
  const Adjacency mesh = scene::adjacency(scene::torus(0.6, 0.25, 20, 10));
  const auto next = scene::next(mesh);
  const glm::dvec4 light(2, 3, 1, 1);
  const VolumeMesh all = volume_lecture(mesh, next, light, Edges::all);
  const VolumeMesh lit = volume_lecture(mesh, next, light, Edges::lit);
  const VolumeMesh outline = volume_lecture(mesh, next, light, Edges::silhouette);
  const VolumeMesh fast = volume(mesh, light, Caps::none);
  // Every edge of a closed mesh has two opposite quads: all cancel, and no shadow is left.
  EXPECT_EQ(all.indices.size(), mesh.triangles.size() * 18);
  EXPECT_TRUE(net_sides(all.indices).empty());
  EXPECT_EQ(net_sides(lit.indices), net_sides(fast.indices));
  EXPECT_GT(lit.indices.size(), 5 * outline.indices.size());
  EXPECT_EQ(net_sides(outline.indices), net_sides(fast.indices));
  EXPECT_EQ(outline.indices.size(), fast.indices.size());
}

}  // namespace
}  // namespace shadowlab::shadow
