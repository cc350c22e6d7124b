// Raising errors of the sandbox from C functions.
#pragma once

#include <lua.hpp>

namespace shadowlab::lua {

/// Raises the sentence of the exhausted budget, which pcall and its kin pass on instead of
/// catching.
[[noreturn]] void raise_exhausted(lua_State* L);

}  // namespace shadowlab::lua
