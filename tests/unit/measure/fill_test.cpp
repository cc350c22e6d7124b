#include "measure/fill.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/version.h"

namespace shadowlab::measure {
namespace {

constexpr int size = 16;

// A quad over the whole frame is 16² pixels, over its left half 8 × 16.
constexpr const char* layers = R"lua(
local recipe = {}
function recipe.setup(r)
  r.flat, r.phong, r.quad = shader.load "flat", shader.load "phong", mesh.quad()
end
function recipe.draw(r)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  pass("depth", function()
    gl.Enable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    r.quad:draw(r.flat)
  end)
  pass("hidden, in the stencil, half of it", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.DepthFunc(gl.NEVER)
    gl.Viewport(0, 0, r.width / 2, r.height)
    r.quad:draw(r.flat)
  end)
  pass("colours", function()
    gl.Viewport(0, 0, r.width, r.height)
    gl.ColorMask(true, true, true, true)
    gl.Disable(gl.STENCIL_TEST)
    gl.DepthFunc(gl.ALWAYS)
    r.quad:draw(r.flat, { color = vec3(1, 0, 0) })
    r.quad:draw(r.flat, { color = vec3(0, 1, 0) })
    r.quad:draw(r.phong, { light = vec4(0, 0, 1, 0), color = vec3(0, 0, 1) })
  end)
end
return recipe
)lua";

class Fill : public testing::Test {
 protected:
  Fill() {
    std::string name = (std::filesystem::temp_directory_path() / "shadowlab fill XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    std::ofstream(folder_ / "layers.lua") << layers;
  }
  ~Fill() override {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
  }
  std::filesystem::path folder_;
  gl::Graphics graphics_{context::create(), size, size};
};

TEST_F(Fill, counts_every_pixel_that_a_pass_rasterises_by_what_it_is_given) {
  recipe::Recipe recipe(graphics_, folder_ / "layers.lua");
  const auto passes = fill_of(graphics_, recipe, 1);
  ASSERT_EQ(passes.size(), 3u);
  const double whole = size * size / (1024.0 * 1024.0);
  using Mpix = std::array<double, layer_count>;  // flat colour, phong, depth, stencil
  EXPECT_EQ(passes[0].mpix, (Mpix{0, 0, whole, 0}));
  EXPECT_EQ(passes[1].mpix, (Mpix{0, 0, 0, whole / 2}))
      << "hidden pixels are rasterised all the same";
  EXPECT_EQ(passes[2].mpix, (Mpix{2 * whole, whole, 0, 0}));
  EXPECT_EQ(passes[2].triangles, 6u);
}

TEST_F(Fill, counting_leaves_the_picture_alone) {
  recipe::Recipe recipe(graphics_, home() / "scripts" / "volumes_zfail.lua");
  recipe.draw();
  const image::Image alone = graphics_.frame.read_color();
  fill_of(graphics_, recipe, 1);
  EXPECT_EQ(graphics_.frame.read_color(), alone);
}

TEST_F(Fill, a_layer_costs_something_of_every_kind) {
  const FillLimit limit = fill_limit(graphics_);
  for (const double layer : limit.layer) EXPECT_GT(layer, 0);
}

}  // namespace
}  // namespace shadowlab::measure
