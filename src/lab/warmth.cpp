#include "lab/warmth.h"

#include "core/error.h"
#include "gl/under_each_state.h"
#include "recipe/recipe.h"

namespace shadowlab::lab {
namespace {

void draw(gl::Graphics& graphics, const std::filesystem::path& file, Warmth warmth) {
  recipe::Recipe recipe(graphics, file);
  recipe.draw();
  (void)graphics.frame.read_color();
  (void)graphics.frame.read_depth();
  (void)graphics.frame.read_stencil();
  if (warmth == Warmth::recipes) return;
  const gl::UnderEachState under(graphics);
  recipe.draw();
}

}  // namespace

void warm_up(gl::Graphics& graphics, std::span<const std::filesystem::path> recipes,
             Warmth warmth) {
  for (const auto& file : recipes) {
    try {
      draw(graphics, file, warmth);
    } catch (const InputError&) {
      // It is then not warm, and nothing else.
    }
  }
  graphics.begin_frame();
  graphics.clear_buffers();
}

}  // namespace shadowlab::lab
