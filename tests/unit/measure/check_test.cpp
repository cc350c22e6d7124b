#include "measure/check.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "core/version.h"

namespace shadowlab::measure {
namespace {

class Check : public testing::Test {
 protected:
  CheckResult row(const std::string& recipe, const std::string& scene, int views,
                  std::vector<std::pair<std::string, std::string>> settings = {}) {
    CheckOptions options;
    options.scene = scene;
    options.views = views;
    options.settings = std::move(settings);
    return check(graphics_, home() / "scripts" / (recipe + ".lua"), options);
  }
  gl::Graphics graphics_{context::create(), 96, 96};
};

// The scene's own camera and light and seven random ones: cameras inside volumes and near planes
// that cut them are among them.
TEST_F(Check, z_fail_and_auto_are_right_everywhere_beyond_a_pixel_of_an_edge) {
  for (const char* recipe : {"volumes_zfail", "volumes_auto"}) {
    for (const char* scene : {"tetra", "table", "room"}) {
      const CheckResult result = row(recipe, scene, 8);
      EXPECT_EQ(result.views, 8) << recipe << ' ' << scene;
      EXPECT_GT(result.pixels, 10000u) << recipe << ' ' << scene;
      EXPECT_EQ(result.wrong_beyond_edge, 0u)
          << recipe << ' ' << scene << " view "
          << (result.wrong_views.empty() ? 0 : result.wrong_views[0].first);
    }
  }
}

// Where a receiver hides the foot of a box by less than depths are rounded, it hides the cap in
// that face too: else z-fail has one count less than z-pass, and a dark pixel at the foot.
TEST(CheckFoot, what_hides_a_caster_hides_the_cap_of_its_volume) {
  gl::Graphics graphics(context::create(), 256, 256);
  for (const char* recipe : {"volumes_zfail", "volumes_auto"}) {
    CheckOptions options;
    options.scene = "lamps";
    options.views = 2;
    EXPECT_EQ(check(graphics, home() / "scripts" / (std::string(recipe) + ".lua"), options).wrong,
              0u)
        << recipe;
  }
}

TEST_F(Check, volumes_that_shaders_make_are_right_everywhere_beyond_a_pixel_of_an_edge) {
  for (const char* extruder : {"vertex", "geometry"}) {
    for (const char* scene : {"tetra", "mobius", "room"}) {
      const CheckResult result = row("volumes_gpu", scene, 8, {{"extruder", extruder}});
      EXPECT_GT(result.pixels, 10000u) << extruder << ' ' << scene;
      EXPECT_EQ(result.wrong_beyond_edge, 0u)
          << extruder << ' ' << scene << " view "
          << (result.wrong_views.empty() ? 0 : result.wrong_views[0].first);
    }
  }
}

TEST_F(Check, z_pass_is_right_where_it_says_that_it_holds) {
  for (const char* recipe : {"volumes_zpass", "volumes_two_sided"}) {
    const CheckResult result = row(recipe, "tetra", 12);
    EXPECT_GT(result.views, 0) << recipe;
    EXPECT_GT(result.outside, 0) << recipe
                                 << ": no view shadows the near plane, so this shows nothing";
    EXPECT_EQ(result.wrong_beyond_edge, 0u)
        << recipe << " view " << (result.wrong_views.empty() ? 0 : result.wrong_views[0].first);
  }
}

TEST_F(Check, a_soft_technique_is_held_against_the_soft_truth) {
  // From above and below, near and far, of lamps only.
  for (const char* scene : {"comb", "mobius"}) {
    const auto blurred = [&](const char* blur) {
      return row("volumes_blurred", scene, 4, {{"blur", blur}, {"radius", "0.15"}});
    };
    const CheckResult soft = blurred("contact"), hard = blurred("none");
    EXPECT_EQ(soft.wrong_beyond_edge, 0u) << scene;  // all is an edge
    EXPECT_GT(hard.rmse, 0.03) << scene;             // which the hard truth would give 0
    EXPECT_LT(soft.rmse, hard.rmse / 2) << scene;
  }
}

TEST_F(Check, a_soft_technique_without_a_light_s_radius_is_refused) {
  const auto file = std::filesystem::path(testing::TempDir()) / "no_radius.lua";
  std::ofstream(file) << R"(
    return { scene = "tetra", truth = "soft", params = { light = param.point(2, 4, 1) },
             draw = function() end })";
  EXPECT_THROW(check(graphics_, file, {}), InputError);
}

TEST_F(Check, the_truth_drawn_as_a_recipe_is_the_truth) {
  const CheckResult result = row("truth", "table", 4);
  // GL's rounding of vertices to 1/256 of a pixel may give a pixel at an edge to the other side.
  EXPECT_EQ(result.wrong_beyond_edge, 0u);
}

TEST_F(Check, a_shadow_in_the_wrong_place_is_seen) {
  CheckOptions options;
  options.scene = "tetra";
  const auto folder = std::filesystem::path(testing::TempDir());
  const auto file = folder / "no_shadow.lua";
  {
    std::ofstream(file) << R"(
      local recipe = { scene = "tetra", truth = "hard", params = { light = param.point(2, 4, 1) } }
      function recipe.setup(r) r.phong = shader.load "phong" end
      function recipe.draw(r)
        gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
        gl.Enable(gl.DEPTH_TEST)
        r.scene:draw(r.phong, { view = r.scene.camera:view(),
                                projection = r.scene.camera:projection(r.width / r.height),
                                light = r.params.light })
      end
      return recipe)";
  }
  EXPECT_GT(check(graphics_, file, options).wrong_beyond_edge, 100u);
}

TEST_F(Check, a_recipe_that_claims_no_truth_is_refused) {
  CheckOptions options;
  EXPECT_THROW(check(graphics_, home() / "scripts" / "stencil_basics.lua", options), InputError);
}

}  // namespace
}  // namespace shadowlab::measure
