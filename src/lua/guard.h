// Where C++ errors become Lua errors.
//
// Debian's lua5.4-c++ raises by `throw`, so the destructors of a binding run when Lua raises
// through it. The other way round, Lua's own catch swallows a foreign exception without a message:
// hence every C function that Lua can call is wrapped in `guarded`.
#pragma once

#include <exception>
#include <lua.hpp>

namespace shadowlab::lua {

/// The function to give to lua_pushcfunction in place of F, which may throw std::exception: its
/// message becomes a Lua error that begins with the script's file and line. Lua's own exceptions
/// (a pointer, not a std::exception) pass through untouched.
template <int (*F)(lua_State*)>
int guarded(lua_State* L) {
  try {
    return F(L);
  } catch (const std::exception& problem) {
    return luaL_error(L, "%s", problem.what());
  }
}

}  // namespace shadowlab::lua
