#include "shadow/map_needs.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "cities.h"
#include "shadow/light_view.h"

namespace shadowlab::shadow {
namespace {

constexpr glm::ivec2 picture{200, 100};

struct Drawn {
  LightView view;
  std::optional<DepthRange> part;
};

// One of a cube's faces, a map of all, or one of what is seen in a part of the view.
Drawn random_map(const City& city, std::mt19937& random) {
  if (city.light.w > 0) return {cube_faces(city.light, 0.01, 100)[random() % 6], {}};
  if (random() % 2 == 0) return {light_view(city.light, city.scene, whole_content(city.scene)), {}};
  const DepthRange part{3, 6};
  const auto view = frustum(city.camera, 2, part.near, part.far);
  return {light_view(city.light, city.scene, {visible_sides(city.scene, view), {}}), part};
}

bool has(const std::vector<std::size_t>& list, std::size_t item) {
  return std::ranges::find(list, item) != list.end();
}

// Texels as wide as a twentieth of the map, lookups of three of them: what is beside the way to the
// light counts as much as what is on it.
TEST(MapNeeds, leaves_out_nothing_that_a_lookup_at_a_seen_point_can_meet) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  int met = 0, beside = 0, left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    const City city = random_city(random);
    const Drawn map = random_map(city, random);
    const glm::dmat4 to_map = map.view.projection * map.view.view;
    const MapUse use{to_map, 20, 3, map.part};
    const MapNeeds needs = map_needs(city.scene, city.camera, city.light, picture, use);
    left_out += static_cast<int>(city.scene.objects.size() - needs.casters.size());
    const glm::dmat4 to_clip = city.camera.projection(2) * city.camera.view();
    for (int k = 0; k < 300; ++k) {
      const std::size_t at = random() % city.scene.objects.size();
      const glm::dvec4 p =
          city.scene.objects[at].model * glm::dvec4(unit(random), unit(random), unit(random), 1);
      const glm::dvec4 clip = to_clip * p;
      if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || clip.z < -clip.w) continue;
      if (map.part && (clip.w < map.part->near || clip.w > map.part->far)) continue;
      const bool hidden = std::ranges::any_of(city.scene.objects, [&](const auto& object) {
        return meets(object, p, glm::dvec4(city.camera.eye, 1)) &&
               &object != &city.scene.objects[at];
      });
      glm::dvec4 place = to_map * p;
      if (hidden || place.w <= 0) continue;
      place /= place.w;
      // A texel's middle that the lookup reads: half a filter and half a texel away at most.
      place += glm::dvec4(unit(random), unit(random), 0, 0) * (2.0 / use.size * (use.filter + 1));
      if (std::abs(place.x) > 1 || std::abs(place.y) > 1) continue;
      glm::dvec4 read = glm::inverse(to_map) * place;
      read /= read.w;
      for (std::size_t caster = 0; caster < city.scene.objects.size(); ++caster) {
        if (!meets(city.scene.objects[caster], read, city.light)) continue;
        EXPECT_TRUE(has(needs.casters, caster)) << "city " << i << ", box " << caster;
        ++met;
        beside += meets(city.scene.objects[caster], p, city.light) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(beside, 200);
  EXPECT_GT(left_out, 5000);
}

scene::Camera down_minus_z() {
  scene::Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  camera.fovy = 90;
  camera.near = 0.1;
  return camera;
}

// A wall at z = -20 and a box before it, lit along z: the eye, three metres beside, sees the
// shadow.
TEST(MapNeeds, of_a_part_of_the_view_in_which_nothing_is_seen_are_none) {
  scene::Scene scene;
  scene.objects = {box_at({0, 0, -20}, {60, 60, 0.1}), box_at({0, 0, -4}, {1, 1, 1})};
  const glm::dvec4 light{0, 0, 1, 0};
  const LightView view = light_view(light, scene, whole_content(scene));
  MapUse use{view.projection * view.view, 256, 1, {}};
  scene::Camera camera = down_minus_z();
  camera.eye.x = camera.target.x = 3;
  use.part = DepthRange{8, 12};
  EXPECT_FALSE(map_needs(scene, camera, light, picture, use).read());
  use.part = DepthRange{3, 12};
  EXPECT_EQ(map_needs(scene, camera, light, picture, use).casters, (std::vector<std::size_t>{1}))
      << "the box shadows itself";
  use.part = DepthRange{8, 40};
  EXPECT_EQ(map_needs(scene, camera, light, picture, use).casters,
            (std::vector<std::size_t>{0, 1}));
}

TEST(MapNeeds, of_a_face_are_what_is_before_it) {
  scene::Scene scene;
  scene.objects = {box_at({0, 0, -20}, {60, 60, 0.1}), box_at({0, 0, -8}, {1, 1, 1})};
  const glm::dvec4 light{0, 0, -5, 1};
  const auto faces = cube_faces(light, 0.01, 100);
  const auto needs = [&](std::size_t face) {
    const MapUse use{faces[face].projection * faces[face].view, 256, 2, {}};
    return map_needs(scene, down_minus_z(), light, picture, use).casters;
  };
  EXPECT_EQ(needs(5), (std::vector<std::size_t>{0, 1}));  // -z
  EXPECT_TRUE(needs(4).empty());                          // +z: toward the eye, where nothing is
  EXPECT_EQ(needs(0), (std::vector<std::size_t>{0})) << "the wall's end is seen on this face";
}

}  // namespace
}  // namespace shadowlab::shadow
