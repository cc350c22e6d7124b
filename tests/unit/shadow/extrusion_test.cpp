// The rule of shaders/extrude_vertex.vert in C++, over the doubled mesh, held against the number of
// triangles between a point and the light.
#include "shadow/extrusion.h"

#include <algorithm>
#include <array>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "casters.h"
#include "shadow/volume.h"
#include "winding.h"

namespace shadowlab::shadow {
namespace {

using scene::Adjacency;

struct Surface {
  std::vector<glm::dvec4> positions;
  std::vector<std::uint32_t> indices;
};

/// What the shader leaves of the doubled mesh of a run.
Surface shaded(const VolumeBuilder& builder, glm::dvec4 light, TriangleRange part = {}) {
  const FacingPlanes& planes = builder.facing();
  const DoubledMesh mesh = doubled_mesh(planes, part);
  const auto scaled = planes.scaled(light);
  const auto runs = ruled_runs(builder, light, part);
  Surface out;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::size_t triangle = part.first + i / DoubledMesh::indices_a_triangle;
    const auto run = std::find_if(runs.begin(), runs.end(),
                                  [&](const RuledRun& r) { return triangle < r.triangles.last; });
    const auto count = [&](const glm::vec4& plane) {
      const float side = glm::dot(plane, scaled.light);
      return side > scaled.bound ? 1 : side < -scaled.bound && !run->lit_faces_alone ? -1 : 0;
    };
    std::array<glm::dvec4, 3> corners;
    bool drawn = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const ExtrudedVertex& v = mesh.vertices[mesh.indices[i + k]];
      const int here = count(v.face);
      drawn = drawn && here != 0 && here != count(v.across);
      const glm::dvec3 p(here < 0 ? v.turned : glm::vec3(v.position));
      corners[k] = v.position.w == 0 ? extruded(p, light) : glm::dvec4(p, 1);
    }
    // A light at infinity pushes all vertices to one point.
    const auto& [a, b, c] = corners;
    if (!drawn || a == b || b == c || c == a) continue;
    for (const glm::dvec4& corner : corners) {
      out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
      out.positions.push_back(corner);
    }
  }
  return out;
}

glm::dvec4 random_point(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  return {coordinate(random), coordinate(random), coordinate(random), 1};
}

std::optional<glm::dvec4> lit_point(const Adjacency& mesh, glm::dvec4 light, std::mt19937& random) {
  for (int trial = 0; trial < 1000; ++trial) {
    const double near = std::pow(0.7, trial % 40);
    const glm::dvec4 q = light.w == 0 ? random_point(random, 3) + light * 50.0
                                      : light + random_point(random, near) * glm::dvec4(1, 1, 1, 0);
    if (blockers(mesh, q, light) == 0) return q;
  }
  return {};
}

void expect_shadow(const Adjacency& mesh, glm::dvec4 light, int points, unsigned seed) {
  std::mt19937 random(seed);
  const Surface surface = shaded(VolumeBuilder(mesh), light);
  const auto open = lit_point(mesh, light, random);
  ASSERT_TRUE(open);
  int told = 0;
  for (int i = 0; i < points; ++i) {
    const glm::dvec4 p = random_point(random, 1.5);
    const auto blocked = blockers(mesh, p, light);
    const auto count = winding(surface.positions, surface.indices, p, *open);
    if (!blocked || !count) continue;
    ++told;
    ASSERT_GE(*count, 0);
    ASSERT_LE(*count, *blocked);
    ASSERT_EQ(*count > 0, *blocked > 0);
  }
  // Points too close to tell are a matter of 1e-10 of the space.
  EXPECT_GE(told, points * 99 / 100);
}

TEST(Extrusion, of_any_caster_holds_a_point_where_a_triangle_hides_the_light) {
  std::mt19937 random(1);
  for (const Caster& caster : casters()) {
    // Floats cannot tell which way triangles a millionth as high as long face: they count nothing.
    if (caster.name == "slivers") continue;
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    for (unsigned trial = 0; trial < 4; ++trial) {
      expect_shadow(mesh, random_point(random, 3), 200, trial);
      expect_shadow(mesh, random_point(random, 0.8), 200, trial);
      expect_shadow(mesh, random_point(random, 3) * glm::dvec4(1, 1, 1, 0), 200, trial);
    }
  }
}

TEST(Extrusion, is_right_with_the_light_in_the_plane_of_faces_and_on_a_vertex) {
  const Adjacency box = scene::adjacency(scene::box());
  for (const double z : {0.5, 0.0}) expect_shadow(box, {3, 0.5, z, 1}, 500, 3);
  expect_shadow(box, {1, 0, 0, 0}, 500, 4);
  expect_shadow(box, {0.5, 0.5, 0.25, 1}, 500, 5);
  expect_shadow(box, {0.5, 0.5, 0.5, 1}, 500, 6);
}

// Each directed edge of the surface as often as its reverse, at welded positions: no crack.
TEST(Extrusion, is_a_closed_surface_for_any_caster_and_light) {
  std::mt19937 random(2);
  const auto less = [](const glm::dvec4& a, const glm::dvec4& b) {
    return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
  };
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    const Adjacency mesh = scene::adjacency(caster.mesh);
    const VolumeBuilder builder(mesh);
    for (int trial = 0; trial < 8; ++trial) {
      // Of the whole, and of some run of it.
      const std::size_t first = trial < 4 ? 0 : random() % builder.triangle_count();
      const TriangleRange run{first, trial < 4 ? builder.triangle_count() : first + 40};
      const Surface surface = shaded(builder, random_point(random, 2), run);
      std::vector<std::pair<glm::dvec4, glm::dvec4>> there, back;
      for (std::size_t i = 0; i < surface.indices.size(); ++i) {
        const std::size_t k = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec4 p = surface.positions[surface.indices[i]],
                         q = surface.positions[surface.indices[k]];
        there.emplace_back(p, q);
        back.emplace_back(q, p);
      }
      const auto by_ends = [&](const auto& a, const auto& b) {
        return less(a.first, b.first) || (!less(b.first, a.first) && less(a.second, b.second));
      };
      std::sort(there.begin(), there.end(), by_ends);
      std::sort(back.begin(), back.end(), by_ends);
      ASSERT_EQ(there, back);
    }
  }
}

// Where no edge joins more than two triangles, or two of different orientations, none is thrown
// twice.
TEST(Extrusion, of_a_sheet_or_a_closed_caster_has_the_triangles_that_the_builder_has) {
  for (const Mesh& caster : {bare(scene::box()), bare(scene::torus(0.6, 0.25, 20, 10)),
                             bare(scene::teapot(1.0, 4)), bare(scene::plane(2, 1, 3, 2))}) {
    const Adjacency mesh = scene::adjacency(caster);
    const glm::dvec4 light(2, 3, 1, 1);
    VolumeBuilder builder(mesh);
    const Surface surface = shaded(builder, light);
    EXPECT_EQ(surface.indices.size(), builder.build(light).all.size());
  }
}

TEST(Extrusion, rules_components_as_the_builder_does) {
  const Mesh ball = bare(scene::sphere(0.8, 16, 9));
  const std::size_t each = scene::adjacency(ball).triangles.size();
  const VolumeBuilder builder(
      joined(joined(ball, turned_round(moved(ball, {5, 0, 0}))), moved(mobius(), {0, 9, 0})));
  const auto ends = [&](glm::dvec4 light, TriangleRange run) {
    std::vector<std::pair<std::size_t, bool>> found;
    for (const RuledRun& r : ruled_runs(builder, light, run))
      found.emplace_back(r.triangles.last, r.lit_faces_alone);
    return found;
  };
  using Ends = std::vector<std::pair<std::size_t, bool>>;
  const std::size_t all = builder.triangle_count();
  EXPECT_EQ(ends({0, 3, 0, 1}, {}), (Ends{{2 * each, true}, {all, false}}));
  EXPECT_EQ(ends({0, 0.1, 0, 1}, {}), (Ends{{each, false}, {2 * each, true}, {all, false}}));
  EXPECT_EQ(ends({0, 3, 0, 1}, {10, 20}), (Ends{{20, true}}));
}

TEST(Extrusion, of_parts_adds_up_to_that_of_the_whole) {
  const Adjacency mesh = scene::adjacency(scene::torus(0.6, 0.25, 20, 10));
  const VolumeBuilder builder(mesh);
  std::mt19937 random(3);
  const glm::dvec4 light(2, 3, 1, 1);
  const auto open = lit_point(mesh, light, random);
  ASSERT_TRUE(open);
  const Surface whole = shaded(builder, light);
  std::vector<Surface> parts;
  for (std::size_t first = 0; first < builder.triangle_count(); first += 37)
    parts.push_back(
        shaded(builder, light, {first, std::min(first + 37, builder.triangle_count())}));
  for (int i = 0; i < 300; ++i) {
    const glm::dvec4 p = random_point(random, 1.5);
    const auto expected = winding(whole.positions, whole.indices, p, *open);
    int sum = 0;
    bool told = expected.has_value();
    for (const Surface& part : parts) {
      const auto count = winding(part.positions, part.indices, p, *open);
      told = told && count.has_value();
      sum += count.value_or(0);
    }
    if (told) {
      ASSERT_EQ(sum, *expected);
    }
  }
}

}  // namespace
}  // namespace shadowlab::shadow
