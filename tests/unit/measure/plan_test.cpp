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
  recipe.set("size", "128");
  const bool is_cube = std::string_view(name) == "shadow_map_cube";
  if (is_cube) recipe.set("keep", "false");
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

// Over a corner of the table, at what no shadow reaches: one texel, 24 bits of depth, stands for
// the map, and one a face for a cube. Where shadows are seen the whole map is there.
TEST(RunUnderAPlan, makes_no_map_that_nobody_reads) {
  using Casters = recipe::Options::Casters;
  const struct {
    const char* name;
    std::uint64_t faces;
  } recipes[] = {{"shadow_map_fbo", 1},
                 {"shadow_map_sampler", 1},
                 {"shadow_map_pcf", 1},
                 {"shadow_map_cube", 6}};
  std::vector<std::uint8_t> without, with;
  for (const auto& [name, faces] : recipes) {
    const std::uint64_t whole = faces * 128 * 128 * 3;
    EXPECT_EQ(held_by(name, Casters::all, {1.8, 2, 2.2}, {1.8, 0, 1.3}, without), whole) << name;
    EXPECT_EQ(held_by(name, Casters::planned, {1.8, 2, 2.2}, {1.8, 0, 1.3}, with), faces * 3)
        << name;
    EXPECT_EQ(with, without) << name;
    EXPECT_EQ(held_by(name, Casters::planned, {3, 3, 5}, {0, 0.5, 0}, with), whole) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Plan,
                         testing::Values("city", "comb", "corner", "mobius", "stairs", "tetra"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace shadowlab::measure
