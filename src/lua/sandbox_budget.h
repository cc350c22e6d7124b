// How much of the machine's time a script may take: a count of instructions and a deadline.
#pragma once

#include <chrono>
#include <cstdint>
#include <lua.hpp>
#include <string>

namespace shadowlab::lua {

/// Counts the instructions of a script over all its coroutines, and the work that native functions
/// do for it, through a Lua count hook. Once it is exhausted, the hook fires at every instruction
/// of the script and raises, and nothing of the script runs again until `restart`.
class Budget {
 public:
  Budget(std::uint64_t instructions, double seconds);

  /// A fresh count and a fresh deadline for the script of main thread `L`.
  void restart(lua_State* L);

  /// Counts `cost` instructions' worth of work and looks at the clock now and then; raises no
  /// error.
  void spend(std::uint64_t cost);

  bool exhausted() const { return !sentence_.empty(); }
  /// What ran out, beginning with the script's file and line where they are known.
  const std::string& sentence() const { return sentence_; }

  /// From now on the script holds a block of this many bytes. A single instruction (a comparison of
  /// strings, say) takes time in proportion, so the hook fires the more often, the larger the
  /// block.
  void note_block(std::size_t bytes);

  /// The thread whose code runs now: the one whose hook must fire first.
  lua_State* running() const { return running_; }
  void set_running(lua_State* L) { running_ = L; }

  /// Gives thread `L` the hook, unless it has it already with the right count.
  void arm(lua_State* L) const;

  /// Instructions between two calls of the hook.
  int interval() const { return exhausted() ? 1 : interval_; }

 private:
  void look_at_clock();
  void exhaust(const std::string& sentence);

  std::uint64_t instructions_;
  double seconds_;
  std::uint64_t spent_ = 0;
  std::uint64_t unlooked_ = 0;  // work since the last look at the clock
  std::chrono::steady_clock::time_point deadline_;
  lua_State* running_ = nullptr;
  std::size_t largest_block_ = 0;
  int interval_;
  std::string sentence_;
};

/// "FILE:LINE: " of the innermost Lua function that runs in `L`, or nothing. Allocates no Lua
/// memory.
std::string position_of(lua_State* L);

}  // namespace shadowlab::lua
