// How much of the machine's time a script may take: a count of instructions and a deadline.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <lua.hpp>
#include <string>

namespace shadowlab::lua {

/// For a limit on instructions: none; the clock alone ends the script.
inline constexpr std::uint64_t uncounted = ~std::uint64_t{0};

/// Bounds the work of a script over all its coroutines, and that of native functions for it. It
/// ends the script through a count hook of Lua, in one of two ways. A limited number of
/// instructions is counted by the hook, which makes each instruction half as slow again or more.
/// Without that limit there is no hook until an alarm sets one, to look at the clock. Once the
/// budget is exhausted, the hook fires at every instruction of the script and raises, and nothing
/// of the script runs again until `restart`.
class Budget {
 public:
  Budget(std::uint64_t instructions, double seconds);

  /// A fresh count and a fresh deadline for the script of main thread `L`.
  void restart(lua_State* L);

  /// Counts `cost` instructions' worth of work and looks at the clock now and then; raises no
  /// error.
  void spend(std::uint64_t cost);

  /// Asks `stop` every 20 ms while a script runs, whether it is to end. It must not throw.
  void stop_when(std::function<bool()> stop) { stop_ = std::move(stop); }

  /// Whether instructions are counted; else an Alarm must call `tick` while the script runs.
  bool counts() const { return counts_; }
  void start_counting() { counts_ = true; }
  /// Makes the script look at the clock at its next instruction. May run within a signal.
  void tick();
  /// What the hook does.
  void on_hook(lua_State* L);

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

  /// Gives thread `L` the hook that it needs now, or none.
  void arm(lua_State* L) const;

  /// Instructions between two calls of the hook; 0: no hook.
  int interval() const { return exhausted() ? 1 : counts_ ? interval_ : 0; }

 private:
  void look_at_clock();
  void exhaust(const std::string& sentence);

  std::uint64_t instructions_;
  double seconds_;
  bool counts_;
  std::uint64_t spent_ = 0;
  std::uint64_t unlooked_ = 0;  // work since the last look at the clock
  std::chrono::steady_clock::time_point deadline_;
  std::function<bool()> stop_;
  std::chrono::steady_clock::time_point next_question_;
  std::atomic<lua_State*> running_ = nullptr;  // a signal reads it
  std::size_t largest_block_ = 0;
  int interval_;
  std::string sentence_;
};

/// "FILE:LINE: " of the innermost Lua function that runs in `L`, or nothing. Allocates no Lua
/// memory.
std::string position_of(lua_State* L);

}  // namespace shadowlab::lua
