// Nothing is allocated in a frame after the first ones: every allocation of this program is
// counted.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <new>

#include "core/version.h"
#include "gl/held.h"
#include "recipe/recipe.h"

namespace {
// Of this thread: drivers have threads of their own.
thread_local std::size_t allocations = 0;
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* const p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// Sanitizers have their own of this one, which does not call the one above.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace shadowlab::recipe {
namespace {

// What a recipe's own tables and functions leave behind is garbage: nothing of it may stay.
std::size_t kept_by_lua(Recipe& recipe) {
  // What has a finalizer goes with the second collection.
  for (int i = 0; i < 2; ++i) lua_gc(recipe.state().raw(), LUA_GCCOLLECT);
  return recipe.state().heap().bytes();
}

class Frames : public testing::TestWithParam<const char*> {};

TEST_P(Frames, of_volumes_allocate_nothing_though_lights_and_casters_move) {
  gl::Graphics graphics(context::create(), 64, 64);
  Options options;
  options.scene = "lamps";
  Recipe recipe(graphics, home() / "scripts" / (std::string(GetParam()) + ".lua"),
                std::move(options));
  const bool one_light = std::string_view(GetParam()) != "volumes_lights";
  const auto draw = [&](int frame) {
    if (one_light) recipe.set_light({std::cos(frame), 3, std::sin(frame), 1});
    recipe.set_model("box", glm::rotate(glm::dmat4(1), 0.1 * frame, glm::dvec3(0, 1, 0)));
    recipe.draw();
  };
  for (int frame = 0; frame < 3; ++frame) draw(frame);
  const gl::Held before = gl::held(graphics.gl);
  const std::size_t lua_before = kept_by_lua(recipe);
  for (int frame = 3; frame < 10; ++frame) {
    const std::size_t already = allocations;
    draw(frame);
    EXPECT_EQ(allocations - already, 0u) << "frame " << frame;
  }
  EXPECT_EQ(gl::held(graphics.gl).buffers.count, before.buffers.count);
  EXPECT_EQ(kept_by_lua(recipe), lua_before);
}

INSTANTIATE_TEST_SUITE_P(Recipes, Frames,
                         testing::Values("volumes_zpass", "volumes_two_sided", "volumes_zfail",
                                         "volumes_auto", "volumes_lights"),
                         [](const auto& recipe) { return std::string(recipe.param); });

}  // namespace
}  // namespace shadowlab::recipe
