// A Lua state with the values, in which a test runs scripts.
#pragma once

#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lua/value.h"

namespace shadowlab::lua {

/// A Lua state with the values; `run` gives what a script returns, as text, or its error.
class Values : public testing::Test {
 protected:
  Values() {
    luaL_openlibs(L());
    open_values(L());
  }
  lua_State* L() const { return state_.get(); }

  std::string run(const std::string& script) const {
    lua_settop(L(), 0);
    if (luaL_loadbuffer(L(), script.data(), script.size(), "=script") == LUA_OK) {
      lua_pcall(L(), 0, 1, 0);
    }
    return luaL_tolstring(L(), -1, nullptr);
  }
  std::string value(const std::string& expression) const { return run("return " + expression); }
  double number(const std::string& expression) const {
    run("return " + expression);
    lua_settop(L(), 1);
    EXPECT_EQ(lua_type(L(), 1), LUA_TNUMBER) << expression << " gives " << value(expression);
    return lua_tonumber(L(), 1);
  }
  void holds(const std::string& condition) const {
    EXPECT_EQ(value(condition), "true") << condition;
  }
  void refuses(const std::string& expression, const std::string& sentence) const {
    EXPECT_EQ(value(expression), "script:1: " + sentence);
  }

 private:
  struct Close {
    void operator()(lua_State* state) const { lua_close(state); }
  };
  std::unique_ptr<lua_State, Close> state_{luaL_newstate()};
};

}  // namespace shadowlab::lua
