// Every allocation of this program is counted.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "casters.h"
#include "shadow/layers.h"
#include "shadow/volume.h"

namespace {
std::atomic<std::size_t> allocations{0};
}

[[gnu::noinline]] void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* const p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// Sanitizers have their own of this one, which does not call the one above.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace shadowlab::shadow {
namespace {

TEST(VolumeBuilder, allocates_nothing_when_the_light_moves) {
  for (const Caster& caster : casters()) {
    VolumeBuilder builder(caster.mesh);
    const std::size_t before = allocations;
    std::size_t indices = 0;
    for (int frame = 0; frame < 100; ++frame) {
      const glm::dvec4 light(std::cos(frame), frame % 7, std::sin(frame), frame % 3);
      indices += builder.build(light).all.size();
      indices += builder.build(light, {.faces = Faces::turned}).all.size();
    }
    EXPECT_GT(indices, 0u);
    EXPECT_EQ(allocations - before, 0u) << caster.name;
  }
}

TEST(Layers, allocate_nothing_for_a_light_that_comes_back) {
  for (const Caster& caster : casters()) {
    VolumeBuilder builder(caster.mesh);
    Layers layers(builder);
    const auto round = [&] {
      std::size_t parts = 0;
      for (int frame = 0; frame < 12; ++frame) {
        parts += layers.parts({std::cos(frame), frame % 7, std::sin(frame), frame % 3}, 8).size();
      }
      return parts;
    };
    const std::size_t parts = round();
    const std::size_t before = allocations;
    EXPECT_EQ(round(), parts);
    EXPECT_EQ(allocations - before, 0u) << caster.name;
  }
}

}  // namespace
}  // namespace shadowlab::shadow
