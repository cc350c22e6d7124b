#include "lua/sandbox_budget.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/sandbox_alarm.h"
#include "lua/sandbox_raise.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// A look at the clock takes some 30 ns and an instruction some 2 ns: one look in a thousand is
// free.
constexpr int usual_interval = 1000;
// Up to this size an instruction on a whole block (1 ns a byte at worst) may be done a thousand
// times between two looks at the clock: a second at worst, and as much for larger blocks.
constexpr std::size_t usual_block = std::size_t{1} << 20;

constexpr std::chrono::milliseconds between_questions{20};

void count_hook(lua_State* L, lua_Debug*) { State::of(L).budget().on_hook(L); }

}  // namespace

Budget::Budget(std::uint64_t instructions, double seconds)
    : instructions_(instructions),
      seconds_(seconds),
      counts_(instructions != uncounted || !Alarm::works()),
      interval_(usual_interval) {
  restart(nullptr);
}

void Budget::restart(lua_State* L) {
  using Clock = std::chrono::steady_clock;
  constexpr double longest = 1e9;  // thirty years: far from what the clock's count of ns can hold
  const Clock::time_point now = Clock::now();
  deadline_ = now + std::chrono::duration_cast<Clock::duration>(
                        std::chrono::duration<double>(std::min(seconds_, longest)));
  next_question_ = now + between_questions;
  spent_ = 0;
  unlooked_ = 0;
  sentence_.clear();
  running_ = L;
  if (L) arm(L);
}

void Budget::spend(std::uint64_t cost) {
  if (exhausted()) return;
  const std::uint64_t left = instructions_ - spent_;
  if (cost > left) {
    spent_ = instructions_;
    exhaust(
        fmt::format("the recipe ran more than {} instructions in one go; does a loop never end?",
                    instructions_));
    return;
  }
  spent_ += cost;
  unlooked_ += cost;
  if (unlooked_ >= static_cast<std::uint64_t>(interval_)) look_at_clock();
}

void Budget::look_at_clock() {
  unlooked_ = 0;
  const auto now = std::chrono::steady_clock::now();
  if (now >= deadline_) {
    return exhaust(fmt::format(
        "the recipe ran for more than {:g} seconds in one go; does a loop never end?", seconds_));
  }
  if (!stop_ || now < next_question_) return;
  next_question_ = now + between_questions;
  if (stop_()) exhaust("the recipe was stopped");
}

void Budget::exhaust(const std::string& sentence) {
  sentence_ = (running_ ? position_of(running_) : std::string()) + sentence;
  if (running_) arm(running_);
}

void Budget::note_block(std::size_t bytes) {
  if (bytes <= largest_block_) return;
  largest_block_ = bytes;
  const std::size_t times = bytes / usual_block + 1;
  interval_ = std::max(1, static_cast<int>(usual_interval / std::min<std::size_t>(times, 1000)));
  if (running_) arm(running_);
}

void Budget::arm(lua_State* L) const {
  const int wanted = interval();
  if (lua_gethookcount(L) == wanted && (lua_gethook(L) == count_hook) == (wanted != 0)) return;
  if (wanted == 0)
    lua_sethook(L, nullptr, 0, 0);
  else
    lua_sethook(L, count_hook, LUA_MASKCOUNT, wanted);
}

// A tick that comes while `arm` is at work may be lost; the next one is not.
void Budget::tick() {
  if (lua_State* const L = running_) lua_sethook(L, count_hook, LUA_MASKCOUNT, 1);
}

void Budget::on_hook(lua_State* L) {
  running_ = L;
  if (counts_)
    spend(static_cast<std::uint64_t>(lua_gethookcount(L)));
  else if (!exhausted())
    look_at_clock();
  if (exhausted()) raise_exhausted(L);
  arm(L);
}

std::string position_of(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0) return fmt::format("{}:{}: ", frame.short_src, frame.currentline);
  }
  return {};
}

void raise_exhausted(lua_State* L) {
  const std::string& sentence = State::of(L).budget().sentence();
  lua_pushlstring(L, sentence.data(), sentence.size());
  lua_error(L);
  std::abort();  // lua_error does not return, but does not say so to the compiler
}

}  // namespace shadowlab::lua
