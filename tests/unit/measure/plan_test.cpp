#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/version.h"
#include "gl/held.h"
#include "measure/check.h"

namespace shadowlab::measure {
namespace {

constexpr int size = 64, views = 21;

class Plan : public testing::TestWithParam<const char*> {};

// Scenes of one and of a hundred casters, of open ones, of ones drawn in several groups; the
// scene's own view and 20 seeded ones, whose near planes cut casters.
TEST_P(Plan, leaves_every_pixel_as_it_is) {
  gl::Graphics graphics(context::create(), size, size);
  recipe::Options options;
  options.scene = GetParam();
  recipe::Recipe with(graphics, home() / "scripts" / "planned.lua", options),
      without(graphics, home() / "scripts" / "volumes_zfail.lua", options);
  const scene::Scene own = *with.scene();
  for (int index = 0; index < views; ++index) {
    const View view = view_of(own, own.lights[0].position, 7, index);
    const auto draw = [&](recipe::Recipe& recipe) {
      recipe.set_camera(view.camera);
      recipe.set_light(view.light);
      recipe.draw();
      return graphics.frame.read_color().rgba;
    };
    EXPECT_EQ(draw(with), draw(without)) << GetParam() << ", view " << index;
  }
}

std::vector<std::string> all_recipes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts")) {
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class RunUnderAPlan : public testing::TestWithParam<std::string> {};

// Whatever a recipe does: its own scene, a street of which much is hidden, and one of large boxes;
// the scenes' own views and seeded ones.
TEST_P(RunUnderAPlan, draws_the_same_picture_with_no_more_triangles) {
  gl::Graphics graphics(context::create(), size, size);
  for (const char* scene : {"", "city", "cornell"}) {
    recipe::Options options;
    if (*scene) options.scene = scene;
    const auto file = home() / "scripts" / (GetParam() + ".lua");
    recipe::Recipe without(graphics, file, options);
    options.casters = recipe::Options::Casters::planned;
    recipe::Recipe with(graphics, file, options);
    const bool has_light = std::ranges::any_of(
        with.parameters(), [](const auto& known) { return known.name == "light"; });
    std::optional<scene::Scene> own;
    if (with.scene() && has_light && !with.scene()->lights.empty()) own = *with.scene();
    for (int index = 0; index < (own ? 4 : 1); ++index) {
      const auto draw = [&](recipe::Recipe& recipe) {
        if (own) {
          const View view = view_of(*own, own->lights[0].position, 11, index);
          recipe.set_camera(view.camera);
          recipe.set_light(view.light);
        }
        // What a recipe refuses, a wall that is no wall, it refuses under a plan too.
        try {
          if (!recipe.holds()) return std::vector<std::uint8_t>();
          recipe.draw();
        } catch (const InputError& refused) {
          const std::string words = refused.what();
          return std::vector<std::uint8_t>(words.begin(), words.end());
        }
        return graphics.frame.read_color().rgba;
      };
      EXPECT_EQ(draw(with), draw(without)) << scene << ", view " << index;
      EXPECT_LE(with.work().triangles, without.work().triangles) << scene << ", view " << index;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Recipes, RunUnderAPlan, testing::ValuesIn(all_recipes()),
                         [](const auto& tested) { return tested.param; });

struct Drawn {
  gl::Work work;
  std::vector<std::uint8_t> picture;
};

Drawn drawn(const char* name, recipe::Options::Casters casters, const char* set,
            const char* value) {
  gl::Graphics graphics(context::create(), size, size);
  recipe::Options options;
  options.scene = "city";
  options.casters = casters;
  recipe::Recipe recipe(graphics, home() / "scripts" / (std::string(name) + ".lua"), options);
  if (set) recipe.set(set, value);
  recipe.draw();
  return {recipe.work(), graphics.frame.read_color().rgba};
}

// In the street most houses are hidden, and each map sees a few of them. What is seen is drawn
// three times whatever is planned, so of all triangles a twentieth goes at the least.
TEST(RunUnderAPlan, draws_less_where_much_is_hidden) {
  const struct {
    const char *name, *set, *value;
  } recipes[] = {{"volumes_zfail", nullptr, nullptr},    {"volumes_auto", nullptr, nullptr},
                 {"volumes_gpu", nullptr, nullptr},      {"volumes_zpass", nullptr, nullptr},
                 {"shadow_map_fbo", nullptr, nullptr},   {"shadow_map_copy", nullptr, nullptr},
                 {"shadow_map_pcf", nullptr, nullptr},   {"shadow_map_stable", nullptr, nullptr},
                 {"shadow_map_cascades", "by", "view"},  {"shadow_map_cascades", "by", "camera"},
                 {"shadow_map_cascades", "by", "groups"}};
  for (const auto& [name, set, value] : recipes) {
    const Drawn without = drawn(name, recipe::Options::Casters::all, set, value),
                with = drawn(name, recipe::Options::Casters::planned, set, value);
    EXPECT_EQ(with.picture, without.picture) << name;
    EXPECT_LT(with.work.triangles, without.work.triangles * 19 / 20) << name;
  }
}

// The bytes of the textures that a first frame makes GL hold, the picture's aside.
std::uint64_t held_by(const char* name, recipe::Options::Casters casters, glm::dvec3 eye,
                      glm::dvec3 target, std::vector<std::uint8_t>& picture) {
  gl::Graphics graphics(context::create(), size, size);
  const std::uint64_t before = gl::held(graphics.gl).textures.bytes;
  recipe::Options options;
  options.scene = "table";
  options.casters = casters;
  recipe::Recipe recipe(graphics, home() / "scripts" / (std::string(name) + ".lua"), options);
  for (const auto& parameter : recipe.parameters()) {
    if (parameter.name == "size") recipe.set("size", "128");
    if (parameter.name == "technique") recipe.set("technique", "maps");
    if (parameter.name == "radius") recipe.set("radius", "0.01");
  }
  if (std::string_view(name) == "shadow_map_cube") recipe.set("keep", "false");
  scene::Camera camera = recipe.scene()->camera;
  camera.eye = eye;
  camera.target = target;
  camera.fovy = 20;
  recipe.set_camera(camera);
  recipe.set_light(recipe.scene()->lights[0].position);
  recipe.draw();
  picture = graphics.frame.read_color().rgba;
  return gl::held(graphics.gl).textures.bytes - before;
}

// Over a corner of the table, at what no shadow reaches: a texel, 24 bits of depth, stands for the
// map, and nothing for a cube, of which that view reads one face without a plan. Where shadows are
// seen the map is there, and the two faces of the cube that the view reads.
TEST(RunUnderAPlan, makes_no_map_that_nobody_reads) {
  using Casters = recipe::Options::Casters;
  constexpr std::uint64_t map = 128 * 128 * 3;
  const struct {
    const char* name;
    std::uint64_t all, unread, seen;
  } recipes[] = {{"shadow_map_fbo", map, 3, map},
                 {"shadow_map_copy", map * 4 / 3, 3, map * 4 / 3},  // 32 bits
                 {"shadow_map_sampler", map, 3, map},
                 {"shadow_map_problems", map, 3, map},
                 {"shadow_map_pcf", map, 3, map},
                 {"shadow_map_pcss", map, 3, map},
                 {"shadow_map_cube", map, 0, 2 * map}};
  std::vector<std::uint8_t> without, with;
  for (const auto& [name, all, unread, seen] : recipes) {
    EXPECT_EQ(held_by(name, Casters::all, {1.8, 2, 2.2}, {1.8, 0, 1.3}, without), all) << name;
    EXPECT_EQ(held_by(name, Casters::planned, {1.8, 2, 2.2}, {1.8, 0, 1.3}, with), unread) << name;
    EXPECT_EQ(with, without) << name;
    EXPECT_EQ(held_by(name, Casters::planned, {3, 3, 5}, {0, 0.5, 0}, with), seen) << name;
  }
}

// An accumulation buffer is there either way, and of the exact map three textures of a texel each.
TEST(RunUnderAPlan, makes_no_map_of_a_point_nor_a_grid_that_nobody_reads) {
  using Casters = recipe::Options::Casters;
  std::vector<std::uint8_t> without, with;
  const auto held = [](const char* name, Casters casters, std::vector<std::uint8_t>& picture) {
    return held_by(name, casters, {1.8, 2, 2.2}, {1.8, 0, 1.3}, picture);
  };
  EXPECT_EQ(held("soft_accumulated", Casters::all, without) - 128 * 128 * 3,
            held("soft_accumulated", Casters::planned, with) - 3);
  EXPECT_EQ(with, without);
  EXPECT_GT(held("shadow_map_exact", Casters::all, without), 256 * 256 * 8);
  EXPECT_EQ(held("shadow_map_exact", Casters::planned, with), 8 + 4 + 16);
  EXPECT_EQ(with, without);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Plan,
                         testing::Values("city", "comb", "corner", "mobius", "stairs", "tetra"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace shadowlab::measure
