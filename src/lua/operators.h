// The operators that every value shares: Lua asks the first operand for its metamethod, then the
// second, so each of these sees every pairing of kinds and numbers.
#pragma once

#include <lua.hpp>

namespace shadowlab::lua {

int add(lua_State* L);
int subtract(lua_State* L);
int multiply(lua_State* L);
int divide(lua_State* L);
int negate(lua_State* L);
int equal(lua_State* L);

}  // namespace shadowlab::lua
