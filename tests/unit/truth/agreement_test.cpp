// The tracer against a second one that shares no code with it, and against itself on worse meshes.
#include <gtest/gtest.h>

#include "plain_tracer.h"
#include "scenes.h"
#include "truth/tracer.h"

namespace shadowlab::truth {
namespace {

// Two tracers that share no code. Where they differ there must be an edge, and there is hardly room
// for that: they differ where rounding decides.
TEST(Tracer, agrees_with_a_plain_tracer_away_from_edges) {
  std::size_t differ = 0;
  for (int k = 0; k < 40; ++k) {
    Random random(static_cast<std::uint64_t>(100 + k));
    const scene::Scene scene = clutter(random);
    const Tracer tracer(scene);
    const PlainTracer plain(scene);
    scene::Camera camera{.eye = point_in(random, {-5, 0.1, -5}, {5, 5, 5}),
                         .target = point_in(random, {-1, 0, -1}, {1, 1, 1})};
    scene::Light light{.position = {point_in(random, {-4, -1, -4}, {4, 6, 4}), k % 4 == 0 ? 0 : 1}};
    const int n = 32;
    const image::FloatImage image = tracer.visibility(camera, light, n, n);
    const image::FloatImage edges = tracer.edge_mask(camera, light, n, n);
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const auto i = static_cast<std::size_t>(y * n + x);
        const bool same = image.values[i] ==
                          static_cast<float>(plain.visible(camera, light.position, n, n, x, y));
        differ += !same;
        ASSERT_TRUE(same || edges.values[i] > 0) << "scene " << k << " pixel " << x << ", " << y;
      }
    }
  }
  EXPECT_EQ(differ, 0u);
}

// Slivers, points, lines, and the same face twice or turned round, which change nothing that is
// exact.
TEST(Tracer, takes_degenerate_and_duplicate_triangles_for_what_they_cover) {
  Random random(11);
  for (int k = 0; k < 10; ++k) {
    scene::Scene scene = clutter(random);
    scene::Scene worse = scene;
    for (scene::Object& o : worse.objects) {
      scene::Mesh mesh = *o.mesh;
      const std::size_t faces = mesh.triangle_count();
      for (std::size_t t = 0; t < faces; ++t) {
        const auto a = mesh.indices[3 * t], b = mesh.indices[3 * t + 1],
                   c = mesh.indices[3 * t + 2];
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(0.5f * (mesh.positions[a] + mesh.positions[b]));
        for (const auto i : {a, a, a, a, b, b, a, middle, b, a, b, c, a, c, b}) {
          mesh.indices.push_back(i);
        }
      }
      mesh.normals.clear();
      mesh.uvs.clear();
      o.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
    }
    const scene::Camera camera{.eye = point_in(random, {2, 1, 2}, {4, 4, 4}),
                               .target = {0, 0.5, 0}};
    const scene::Light light = point_light(point_in(random, {-3, 2, -3}, {3, 6, 3}));
    EXPECT_EQ(Tracer(scene).visibility(camera, light, 64, 64).values,
              Tracer(worse).visibility(camera, light, 64, 64).values);
  }
}

}  // namespace
}  // namespace shadowlab::truth
