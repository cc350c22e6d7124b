#include <gtest/gtest.h>

#include "core/version.h"
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

// The same for a recipe that knows of no plan, run under one.
TEST(PlannedCasters, leave_every_pixel_of_other_recipes_as_it_is) {
  gl::Graphics graphics(context::create(), size, size);
  for (const char* name : {"volumes_zfail", "volumes_auto", "volumes_gpu"}) {
    recipe::Options options;
    options.scene = "city";
    const auto file = home() / "scripts" / (std::string(name) + ".lua");
    recipe::Recipe without(graphics, file, options);
    options.casters = recipe::Options::Casters::planned;
    recipe::Recipe with(graphics, file, options);
    const scene::Scene own = *with.scene();
    for (int index = 0; index < 8; ++index) {
      const View view = view_of(own, own.lights[0].position, 9, index);
      const auto draw = [&](recipe::Recipe& recipe) {
        recipe.set_camera(view.camera);
        recipe.set_light(view.light);
        recipe.draw();
        return graphics.frame.read_color().rgba;
      };
      EXPECT_EQ(draw(with), draw(without)) << name << ", view " << index;
      if (index == 0) {
        EXPECT_LT(with.work().triangles, without.work().triangles) << name;
      }
    }
    EXPECT_TRUE(with.scene()->objects[8].casts()) << "roles are as before after the frame";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Plan,
                         testing::Values("city", "comb", "corner", "mobius", "stairs", "tetra"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace shadowlab::measure
