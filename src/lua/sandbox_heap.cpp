#include "lua/sandbox_heap.h"

#include <cstdlib>

#include "lua/sandbox_budget.h"

namespace shadowlab::lua {
namespace {

// Concatenations and growing tables copy blocks without running an instruction: blocks this large
// are charged for, in bytes for each instruction.
constexpr std::size_t large_block = std::size_t{64} << 10;
constexpr std::size_t bytes_per_instruction = 64;

}  // namespace

void* Heap::allocate(void* heap, void* block, std::size_t old_size, std::size_t new_size) {
  Heap& self = *static_cast<Heap*>(heap);
  if (!block) old_size = 0;  // then it tells the kind of object
  if (new_size == 0) {
    std::free(block);
    self.bytes_ -= old_size;
    return nullptr;
  }
  if (new_size > old_size) {
    if (new_size >= large_block) {
      self.budget_.note_block(new_size);
      self.budget_.spend(new_size / bytes_per_instruction);
      if (self.budget_.exhausted()) return nullptr;
    }
    if (!self.may_grow(new_size - old_size)) return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  // Lua relies on shrinking to succeed.
  if (!moved && new_size <= old_size) moved = block;
  if (moved) self.bytes_ = self.bytes_ - old_size + new_size;
  return moved;
}

bool Heap::may_grow(std::size_t more) {
  ++requests_;
  const bool fails_on_purpose = fail_at_ != 0 && requests_ >= fail_at_;
  if (!fails_on_purpose && more <= cap_ - bytes_) return true;
  // Each refusal makes Lua walk through all it holds, so it costs as much.
  budget_.spend(bytes_ / bytes_per_instruction);
  refused_at_ = budget_.running() ? position_of(budget_.running()) : std::string();
  return false;
}

bool Heap::take(std::size_t bytes) {
  if (!may_grow(bytes)) return false;
  bytes_ += bytes;
  return true;
}

}  // namespace shadowlab::lua
