// Six views from a point light, and which of them a frame needs.
#include <gtest/gtest.h>

#include "core/error.h"
#include "shadow/light_view.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

// Face, s and t of a direction, as OpenGL 4.5, table 8.19, has them; s and t in [-1, 1].
struct Place {
  std::size_t face;
  dvec2 st;
};
Place place_of(dvec3 r) {
  const dvec3 a = glm::abs(r);
  if (a.x >= a.y && a.x >= a.z) return {r.x > 0 ? 0u : 1u, dvec2(r.x > 0 ? -r.z : r.z, -r.y) / a.x};
  if (a.y >= a.z) return {r.y > 0 ? 2u : 3u, dvec2(r.x, r.y > 0 ? r.z : -r.z) / a.y};
  return {r.z > 0 ? 4u : 5u, dvec2(r.z > 0 ? r.x : -r.x, -r.y) / a.z};
}

TEST(CubeFaces, draw_a_direction_where_a_lookup_by_it_reads) {
  const dvec3 light(3, -2, 7);
  const auto faces = cube_faces(dvec4(light, 1), 0.5, 20);
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        const dvec3 r(x + 0.25, y - 0.125, z + 0.0625);
        const Place place = place_of(r);
        const dvec4 clip =
            faces[place.face].projection * faces[place.face].view * dvec4(light + r, 1);
        EXPECT_LT(glm::length(dvec2(clip) / clip.w - place.st), 1e-14);  // order-one arithmetic
        EXPECT_NEAR(clip.w, std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)}), 1e-14);
      }
    }
  }
}

TEST(CubeFaces, meet_without_a_gap_at_all_edges_and_corners) {
  const auto faces = cube_faces({0, 0, 0, 1}, 1, 10);
  int edges = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) < 2) continue;
        int on = 0;  // faces on whose border this direction is, exactly
        for (const LightView& face : faces) {
          const dvec4 clip = face.projection * face.view * dvec4(x, y, z, 1);
          if (clip.w == 1 && std::max(std::abs(clip.x), std::abs(clip.y)) == 1) ++on;
        }
        EXPECT_EQ(on, std::abs(x) + std::abs(y) + std::abs(z));
        ++edges;
      }
    }
  }
  EXPECT_EQ(edges, 12 + 8);
}

TEST(CubeFaces, take_near_and_far_to_the_ends_of_depth) {
  const auto faces = cube_faces({0, 0, 0, 1}, 0.25, 8);
  for (const auto& [distance, depth] : {std::pair(0.25, -1.0), {8.0, 1.0}}) {
    const dvec4 clip = faces[0].projection * faces[0].view * dvec4(distance, 0, 0, 1);
    EXPECT_NEAR(clip.z / clip.w, depth, 1e-15);
  }
  EXPECT_THROW(cube_faces({0, 0, 0, 1}, 0, 1), InputError);
  EXPECT_THROW(cube_faces({0, 0, 0, 1}, 2, 1), InputError);
  EXPECT_THROW(cube_faces({0, 1, 0, 0}, 1, 2), InputError);
}

scene::Scene ball_over_floor() {
  scene::Scene scene;
  scene.objects.resize(2);
  scene.objects[0].mesh = std::make_shared<const scene::Mesh>(scene::plane(40, 40));
  scene.objects[0].role = scene::Role::receiver;
  scene.objects[0].model[3] = dvec4(0, -4, 0, 1);
  scene.objects[1].mesh = std::make_shared<const scene::Mesh>(scene::box(dvec3(1)));
  scene.objects[1].role = scene::Role::caster;
  scene.objects[1].model[3] = dvec4(0, -2, 0, 1);
  return scene;
}

TEST(CubeFaces, are_needed_where_both_a_caster_and_a_receiver_are) {
  const auto scene = ball_over_floor();
  const auto needed = faces_needed({0, 0, 0, 1}, scene, whole_content(scene));
  EXPECT_EQ(needed, (std::array{false, false, false, true, false, false}));
}

TEST(CubeFaces, range_is_from_before_the_nearest_caster_to_behind_the_farthest_receiver) {
  const auto scene = ball_over_floor();
  const auto range = cube_range({0, 0, 0, 1}, scene, whole_content(scene));
  // The box's top is 1.5 below, and on a diagonal a face's axis is √3 shorter.
  EXPECT_NEAR(range.near, 1.5 * 0.999 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(range.far, 1.001 * std::sqrt(20.0 * 20 + 20 * 20 + 4 * 4), 1e-12);
  EXPECT_THROW(cube_range({0, 1, 0, 0}, scene, whole_content(scene)), InputError);
}

}  // namespace
}  // namespace shadowlab::shadow
