// Runs pieces of Lua in a State with small limits, for the tests of the sandbox.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"
#include "lua/state.h"

namespace shadowlab::lua {

// Enough for every harmless script of these tests; what never stops hits it within half a second.
inline Limits small_limits() {
  Limits limits;
  limits.memory = std::size_t{16} << 20;
  limits.instructions = 1'000'000;
  limits.seconds = 0.5;
  limits.printed = 1000;
  return limits;
}

struct Attack {
  const char* name;
  const char* text;
};
inline std::ostream& operator<<(std::ostream& out, const Attack& attack) {
  return out << attack.name;
}
inline std::string name_of(const testing::TestParamInfo<Attack>& info) { return info.param.name; }

inline constexpr const char* end_of_budget = " in one go; does a loop never end?";

class Script {
 public:
  explicit Script(const Limits& limits = small_limits())
      : state_(limits, [this](std::string_view line) { printed_ += line; }) {}

  State& state() { return state_; }
  lua_State* raw() { return state_.raw(); }
  const std::string& printed() const { return printed_; }

  /// Whether the script went on after its end and set the global `escaped`.
  bool escaped() {
    lua_pushglobaltable(raw());
    lua_pushliteral(raw(), "escaped");
    const bool set = lua_rawget(raw(), -2) != LUA_TNIL;
    lua_pop(raw(), 2);
    return set;
  }

  /// What the chunk returns, as text.
  std::string value(std::string_view text) {
    state_.load_text(text, "a.lua");
    state_.call(0, 1);
    std::string result(push_text(raw(), -1));
    lua_settop(raw(), 0);
    return result;
  }

  /// The sentence of the error that the chunk ends with.
  std::string error(std::string_view text) {
    try {
      const std::string result = value(text);
      return "no error, but " + result;
    } catch (const InputError& problem) {
      EXPECT_EQ(lua_gettop(raw()), 0);
      return problem.what();
    }
  }

 private:
  std::string printed_;
  State state_;
};

}  // namespace shadowlab::lua
