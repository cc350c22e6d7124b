// Several lights: each alone against its own truth, and all together as their sum.
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/version.h"
#include "measure/check.h"
#include "truth/tracer.h"

namespace shadowlab::measure {
namespace {

constexpr int size = 96;
constexpr int background = 217;  // 0.85: an outline's pixel that the rasteriser leaves out

class Lights : public testing::Test {
 protected:
  Lights() {
    recipe::Options options;
    options.shading = recipe::Options::Shading::visibility;
    recipe_.emplace(graphics_, home() / "scripts" / "volumes_lights.lua", std::move(options));
    recipe_->set("darkness", "0");
  }
  // Lights that may shadow, weighed so that all together give white.
  image::Image picture(std::size_t only) {
    recipe_->set("only", std::to_string(only));
    recipe_->draw();
    return graphics_.frame.read_color();
  }

  gl::Graphics graphics_{context::create(), size, size};
  std::optional<recipe::Recipe> recipe_;
};

TEST_F(Lights, are_each_right_beyond_a_pixel_of_an_edge_and_add_up) {
  const scene::Scene scene = *recipe_->scene();
  ASSERT_EQ(scene.lights.size(), 3u);
  const truth::Tracer tracer(scene);
  std::size_t compared = 0;
  for (int index = 0; index < 6; ++index) {
    const View view = view_of(scene, scene.lights[0].position, 1, index);
    recipe_->set_camera(view.camera);
    const auto surfaces = tracer.surfaces(view.camera, size, size);
    std::vector<int> sum(size * size, 0);
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
      const image::Image alone = picture(light + 1);
      const auto truth = tracer.visibility(view.camera, scene.lights[light], size, size);
      const auto edges = tracer.edge_mask(view.camera, scene.lights[light], size, size, 4);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const int red = alone.rgba[4 * i];
        if (red == background || !surfaces.surfaces[i].hit()) continue;
        sum[i] += red;
        ++compared;
        // A third of 255: exact, where it is not 0.
        ASSERT_TRUE(red == 0 || red == 85) << red;
        wrong += edges.values[i] == 0 && (red == 85) != (truth.values[i] > 0.5f);
      }
      EXPECT_EQ(wrong, 0u) << "view " << index << ", light " << light + 1;
    }
    const image::Image all = picture(0);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (all.rgba[4 * i] == background || !surfaces.surfaces[i].hit()) continue;
      ASSERT_EQ(all.rgba[4 * i], sum[i]) << "view " << index;
    }
  }
  EXPECT_GT(compared, 10000u);
}

}  // namespace
}  // namespace shadowlab::measure
