#include "shadow/layers.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "casters.h"
#include "winding.h"

namespace shadowlab::shadow {
namespace {

glm::dvec4 random_light(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-3, 3);
  return {coordinate(random), coordinate(random), coordinate(random), random() % 3 == 0 ? 0 : 1};
}

std::vector<glm::dvec4> extruded_vertices(const VolumeBuilder& builder, glm::dvec4 light) {
  std::vector<glm::dvec4> positions;
  for (const glm::vec4& v : builder.vertices()) {
    positions.push_back(v.w != 0 ? glm::dvec4(v) : extruded(glm::dvec3(v), light));
  }
  return positions;
}

void expect_all_in_order(std::span<const Part> parts, std::size_t triangles) {
  ASSERT_FALSE(parts.empty());
  EXPECT_EQ(parts.front().triangles.first, 0u);
  EXPECT_EQ(parts.back().triangles.last, triangles);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    EXPECT_EQ(parts[i].triangles.last, parts[i + 1].triangles.first);
  }
}

// Between random points and the light: counts by exact crossings.
TEST(Layers, no_ray_from_the_light_meets_more_triangles_of_a_part_than_it_says) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    VolumeBuilder builder(caster.mesh);
    Layers layers(builder);
    for (int trial = 0; trial < 6; ++trial) {
      // Near the caster, so that rays go every way, and far from it.
      const glm::dvec4 light =
          random_light(random) * glm::dvec4(glm::dvec3(trial % 2 == 0 ? 1 : 0.2), 1);
      for (const std::size_t most : {3u, 16u, 127u}) {
        const auto parts = layers.parts(light, most);
        expect_all_in_order(parts, builder.triangle_count());
        const auto chain = builder.chain(light);
        for (const Part& part : parts) {
          EXPECT_LE(part.layers, most);
          for (int i = 0; i < 200 / static_cast<int>(parts.size()); ++i) {
            const glm::dvec4 p(coordinate(random), coordinate(random), coordinate(random), 1);
            std::size_t met = 0;
            for (std::size_t t = part.triangles.first; t < part.triangles.last; ++t) {
              if (chain[t] == 0) continue;
              const auto& [a, b, c] = builder.facing().triangles()[t];
              const auto at = [&](std::uint32_t v) {
                return glm::dvec4(builder.facing().positions()[v], 1);
              };
              met += crossing(at(a), at(b), at(c), p, light).value_or(0) != 0 ? 1 : 0;
            }
            ASSERT_LE(met, part.layers);
          }
        }
      }
    }
  }
}

TEST(Layers, volumes_of_the_parts_add_up_to_the_whole_one_and_are_closed) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (const Caster& caster : casters()) {
    SCOPED_TRACE(caster.name);
    VolumeBuilder builder(caster.mesh);
    Layers layers(builder);
    const glm::dvec4 light = random_light(random);
    const auto positions = extruded_vertices(builder, light);
    const auto whole = builder.build(light).all;
    const std::vector<std::uint32_t> all(whole.begin(), whole.end());
    const auto found = layers.parts(light, 3);
    const std::vector<Part> parts(found.begin(), found.end());
    const glm::dvec4 open = light + glm::dvec4(0.001, 0.002, 0.003, 0) * (1 - light.w);
    for (int i = 0; i < 30; ++i) {
      const glm::dvec4 p(coordinate(random), coordinate(random), coordinate(random), 1);
      const auto expected = winding(positions, all, p, open);
      std::optional<int> sum = 0;
      for (const Part& part : parts) {
        const auto built = builder.build(light, {.triangles = part.triangles}).all;
        const auto own = winding(positions, {built.begin(), built.end()}, p, open);
        if (!own) {
          sum.reset();
          break;
        }
        EXPECT_LE(std::abs(*own), static_cast<int>(part.layers));
        *sum += *own;
      }
      if (expected && sum) {
        EXPECT_EQ(*sum, *expected);
      }
    }
  }
}

TEST(Layers, of_most_casters_need_one_part_of_a_few_layers) {
  std::mt19937 random(5);
  const Mesh teapot = scene::teapot(1, 10), torus = scene::torus(0.6, 0.2, 48, 24);
  for (const Mesh& mesh : {teapot, torus, scene::sphere(1, 100, 50)}) {
    VolumeBuilder builder(mesh);
    Layers layers(builder);
    for (int trial = 0; trial < 20; ++trial) {
      const auto parts = layers.parts(random_light(random));
      ASSERT_EQ(parts.size(), 1u);
      EXPECT_LE(parts[0].layers, 40u);
    }
  }
}

TEST(Layers, of_a_convex_caster_are_one_and_two_for_a_light_within_its_box) {
  VolumeBuilder box(scene::box());
  Layers layers(box);
  const auto one = [&](glm::dvec4 light) {
    const auto parts = layers.parts(light);
    EXPECT_EQ(parts.size(), 1u);
    return parts[0].layers;
  };
  EXPECT_EQ(one({2, 1, 0, 1}), 1u);
  EXPECT_EQ(one({2, 1, 0, 0}), 1u);
  EXPECT_EQ(one({0.1, 0.2, 0.3, 1}), 2u);
}

// Faces doubled where they are: on the hull, but met twice.
TEST(Layers, count_the_sheets_of_a_box_whose_faces_are_there_twice) {
  Mesh box = bare(scene::box());
  const std::vector<std::uint32_t> once = box.indices;
  box.indices.insert(box.indices.end(), once.begin(), once.end());
  VolumeBuilder builder(box);
  Layers layers(builder);
  const auto parts = layers.parts({1, 2, 3, 1});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_GE(parts[0].layers, 2u);
}

TEST(Layers, of_nested_shells_in_one_mesh_are_split_where_7_bits_end) {
  for (const int count : {127, 128, 255, 256, 300}) {
    VolumeBuilder builder(shells(count));
    Layers layers(builder);
    for (const glm::dvec4& light : {glm::dvec4(1000, 2000, 1500, 1), glm::dvec4(1, 2, 1.5, 0)}) {
      const auto found = layers.parts(light);
      const std::vector<Part> parts(found.begin(), found.end());
      EXPECT_EQ(parts.size() == 1, count <= 127);
      expect_all_in_order(parts, builder.triangle_count());
      const auto positions = extruded_vertices(builder, light);
      int sum = 0;
      for (const Part& part : parts) {
        const auto built = builder.build(light, {.triangles = part.triangles}).all;
        const auto inside = winding(positions, {built.begin(), built.end()}, {0.1, 0.2, 0.3, 1},
                                    {900, 1900, 1600, 1});
        ASSERT_TRUE(inside);
        EXPECT_GT(*inside, 0);
        EXPECT_LE(*inside, 127);
        sum += *inside;
      }
      EXPECT_EQ(sum, count);
    }
  }
}

TEST(Layers, of_nothing_are_one_part_without_any) {
  VolumeBuilder builder(Mesh{});
  Layers layers(builder);
  ASSERT_EQ(layers.parts({1, 2, 3, 1}).size(), 1u);
  EXPECT_EQ(layers.parts({1, 2, 3, 1})[0].layers, 0u);
}

}  // namespace
}  // namespace shadowlab::shadow
