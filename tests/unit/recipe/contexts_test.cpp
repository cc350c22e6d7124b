// One recipe in every context, and several contexts side by side: the same pixels.
#include <cstdlib>

#include "recipe_fixture.h"

namespace shadowlab::recipe {
namespace {

constexpr int size = 200;

std::optional<context::Context> made(context::Backend backend) {
  if (backend == context::Backend::glfw && !std::getenv("DISPLAY")) return {};
  return context::create(backend);
}

image::Image drawn(gl::Graphics& graphics, const std::filesystem::path& recipe) {
  Recipe drawing(graphics, recipe);
  drawing.draw();
  return graphics.frame.read_color();
}

class InEveryContext : public testing::TestWithParam<context::Backend> {
 protected:
  // Against OSMesa, which is the default.
  static void expect_the_same(const std::filesystem::path& recipe) {
    auto other = made(GetParam());
    if (!other) GTEST_SKIP() << "GLFW needs a display";
    const std::string renderer = other->renderer;
    gl::Graphics theirs(std::move(*other), size, size);
    const image::Image picture = drawn(theirs, recipe);
    gl::Graphics ours(context::create(context::Backend::osmesa), size, size);
    if (ours.context().renderer != renderer) GTEST_SKIP() << renderer << " is another driver";
    EXPECT_EQ(drawn(ours, recipe), picture);
  }
};

TEST_P(InEveryContext, the_projected_shadow_has_the_same_pixels) {
  expect_the_same(home() / "scripts" / "projected_stencil.lua");
}

TEST_P(InEveryContext, stencil_blending_and_accumulation_have_the_same_pixels) {
  const RecipeFile file(stencil_blend_accum);
  expect_the_same(file.path());
}

std::string name_of(const testing::TestParamInfo<context::Backend>& context) {
  return std::string(context::name_of(context.param));
}
INSTANTIATE_TEST_SUITE_P(Contexts, InEveryContext,
                         testing::Values(context::Backend::egl, context::Backend::glfw), name_of);

TEST(SideBySide, contexts_draw_interleaved_what_each_draws_alone) {
  const RecipeFile file(stencil_blend_accum);
  const auto stock = home() / "scripts" / "projected_stencil.lua";
  gl::Graphics one(context::create(context::Backend::osmesa), size, size);
  const image::Image first = drawn(one, stock), second = drawn(one, file.path());

  gl::Graphics two(context::create(context::Backend::osmesa), size, size);
  gl::Graphics three(context::create(context::Backend::egl), size, size);
  // Each is made while another context is current.
  Recipe in_one(one, stock), in_two(two, file.path()), in_three(three, stock);
  for (int i = 0; i < 3; ++i) {
    in_one.draw();
    EXPECT_EQ(one.frame.read_color(), first);
    in_two.draw();
    EXPECT_EQ(two.frame.read_color(), second);
    in_three.draw();
    EXPECT_EQ(three.frame.read_color(), first);
    EXPECT_EQ(one.frame.read_color(), first) << "read while another context is current";
  }
}

}  // namespace
}  // namespace shadowlab::recipe
