#include "measure/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/version.h"

namespace shadowlab::measure {
namespace {

TEST(Trial, of_one_number_is_always_the_same_and_of_another_is_not) {
  EXPECT_EQ(lua_of(trial_of(3, 17)), lua_of(trial_of(3, 17)));
  EXPECT_NE(lua_of(trial_of(3, 17)), lua_of(trial_of(3, 18)));
  EXPECT_NE(lua_of(trial_of(3, 17)), lua_of(trial_of(4, 17)));
}

TEST(Trial, is_a_scene_with_a_camera_that_sees) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const scene::Scene scene = scene_of(trial_of(1, i));
    EXPECT_NO_THROW(scene.camera.view()) << i;
    EXPECT_GE(scene.objects.size(), 2u);
    for (const scene::Object& object : scene.objects) EXPECT_NO_THROW(scene::check(*object.mesh));
  }
}

TEST(Shrunk, keeps_what_departs_and_drops_what_does_not_matter) {
  // Departs where some caster is higher than 1.2, whatever else there is.
  const auto departs = [](const Trial& trial) {
    for (const TrialCaster& caster : trial.casters) {
      if (caster.place.y > 1.2) return true;
    }
    return false;
  };
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Trial trial = trial_of(1, i);
    if (!departs(trial)) continue;
    const Trial small = shrunk(trial, departs);
    EXPECT_TRUE(departs(small));
    ASSERT_EQ(small.casters.size(), 1u);
    EXPECT_EQ(small.casters[0].shape, Shape::box);
    EXPECT_EQ(small.casters[0].degrees, 0);
    EXPECT_EQ(small.unit, 1);
    EXPECT_EQ(small.offset, glm::dvec3(0));
    EXPECT_EQ(small.casters[0].place.y, std::round(small.casters[0].place.y * 8) / 8);
  }
}

TEST(Shrunk, ends_after_as_many_tries_as_it_may_have) {
  int tries = 0;
  shrunk(
      trial_of(1, 1), [&](const Trial&) { return ++tries, true; }, 7);
  EXPECT_EQ(tries, 7);
}

TEST(Search, finds_the_shadow_that_a_recipe_does_not_draw_and_makes_it_simple) {
  const auto file = std::filesystem::path(testing::TempDir()) / "all_lit.lua";
  std::ofstream(file) << R"lua(
    local recipe = { scene = "tetra", truth = "hard", params = { light = param.point(2, 4, 1) } }
    function recipe.setup(r) r.phong = shader.load "phong" end
    function recipe.draw(r)
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      gl.Enable(gl.DEPTH_TEST)
      r.scene:draw(r.phong, { view = r.scene.camera:view(), light = r.params.light,
                              projection = r.scene.camera:projection(r.width / r.height) })
    end
    return recipe)lua";
  SearchOptions options;
  options.recipes = {{file, {}}};
  options.trials = 2;
  std::size_t told = 0;
  const auto found = search(options, {}, [&](const Departure&) { ++told; }).departures;
  EXPECT_EQ(told, found.size());
  ASSERT_GT(found.size(), 0u);
  EXPECT_EQ(found[0].trial.casters.size(), 1u);
  EXPECT_GT(found[0].beyond_edge, 0u);
  EXPECT_EQ(found[0].error, "");
}

TEST(Search, says_once_what_fails_in_every_world) {
  const auto file = std::filesystem::path(testing::TempDir()) / "fails.lua";
  std::ofstream(file) << R"lua(
    return { scene = "tetra", truth = "hard", params = { light = param.point(2, 4, 1) },
             draw = function() error "no" end })lua";
  SearchOptions options;
  options.recipes = {{file, {}}};
  options.trials = 3;
  const auto found = search(options, {}, {}).departures;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].error.find("no"), std::string::npos);
}

}  // namespace
}  // namespace shadowlab::measure
