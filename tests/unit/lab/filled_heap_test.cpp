// What is freed before is not used again: it is fresh memory that a forked process begins with.
#include "lab/filled_heap.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdint>

namespace shadowlab::lab {
namespace {

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
TEST(FilledHeap, the_next_block_is_at_the_heaps_end) {
  // Blocks of the heap, however large; every second one is then a hole.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  std::vector<std::unique_ptr<char[]>> blocks(64);
  for (auto& block : blocks) block = std::make_unique<char[]>(100'000);
  for (std::size_t i = 0; i < blocks.size(); i += 2) blocks[i].reset();
  const auto end_before = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  const auto place = [] {
    const auto block = std::make_unique<char[]>(50'000);
    return reinterpret_cast<std::uintptr_t>(block.get());
  };
  EXPECT_LT(place(), reinterpret_cast<std::uintptr_t>(blocks.back().get()));
  {
    const FilledHeap filled;
    EXPECT_GE(place(), reinterpret_cast<std::uintptr_t>(blocks.back().get()));
  }
  EXPECT_LT(place(), end_before);
}
#endif

}  // namespace
}  // namespace shadowlab::lab
