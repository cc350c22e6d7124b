// How much memory a script may hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string>

namespace shadowlab::lua {

class Budget;

/// The allocator of one Lua state, with a cap on the bytes alive. Past the cap Lua collects its
/// garbage and raises "not enough memory" if that does not help. Finalizers alone get what they ask
/// for: Lua calls one in a frame that it allocates, and drops the value whose finalizer it could
/// not call together with all that the value owns. They are ours, a script has none, and each gives
/// back more than its frame takes.
class Heap {
 public:
  Heap(std::size_t cap, Budget& budget) : cap_(cap), budget_(budget) {}

  /// The state that the heap is for, as soon as there is one.
  void serve(lua_State* L) { lua_ = L; }
  /// A lua_Alloc whose `heap` is a Heap.
  static void* allocate(void* heap, void* block, std::size_t old_size, std::size_t new_size);

  std::size_t cap() const { return cap_; }
  std::size_t bytes() const { return bytes_; }
  /// Requests for more memory so far, for tests that fail each in turn.
  std::uint64_t requests() const { return requests_; }
  /// The k-th request for more memory from now (1: the next) and all after it fail; 0: none does.
  void fail_from(std::uint64_t k) { fail_at_ = k == 0 ? 0 : requests_ + k; }

  /// Where the script was when a request was last refused: "FILE:LINE: ", or nothing.
  const std::string& refused_at() const { return refused_at_; }

  /// Counts bytes that a binding holds outside Lua; false, and nothing counted, if they do not fit.
  bool take(std::size_t bytes);
  void give(std::size_t bytes) { bytes_ -= bytes; }

 private:
  bool may_have(std::size_t block, std::size_t more);
  bool may_grow(std::size_t more);
  bool finalizing() const;

  lua_State* lua_ = nullptr;
  std::size_t cap_;
  Budget& budget_;
  std::size_t bytes_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t fail_at_ = 0;
  std::string refused_at_;
};

}  // namespace shadowlab::lua
