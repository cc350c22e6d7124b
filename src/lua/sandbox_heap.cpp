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
  if (new_size > old_size && !self.may_have(new_size, new_size - old_size) && !self.finalizing()) {
    return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  // Lua relies on shrinking to succeed.
  if (!moved && new_size <= old_size) moved = block;
  if (moved) self.bytes_ = self.bytes_ - old_size + new_size;
  return moved;
}

// The collector answers -1, whatever it is asked, while it calls a finalizer.
bool Heap::finalizing() const { return lua_ && lua_gc(lua_, LUA_GCISRUNNING) == -1; }

bool Heap::may_have(std::size_t block, std::size_t more) {
  if (block >= large_block) {
    budget_.note_block(block);
    budget_.spend(block / bytes_per_instruction);
    if (budget_.exhausted()) return false;
  }
  return may_grow(more);
}

bool Heap::may_grow(std::size_t more) {
  ++requests_;
  const bool fails_on_purpose = fail_at_ != 0 && requests_ >= fail_at_;
  const std::size_t room = cap_ > bytes_ ? cap_ - bytes_ : 0;  // finalizers may be past the cap
  if (!fails_on_purpose && more <= room) return true;
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
