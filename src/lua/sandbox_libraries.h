// The libraries of the sandbox: each function adds to the table of globals, or replaces what Lua's
// own library put there.
#pragma once

#include <lua.hpp>

namespace shadowlab::lua {

/// Opens every library, then removes what a recipe may not have. A lua_CFunction.
int open_libraries(lua_State* L);

void add_base(lua_State* L);
void add_pairs(lua_State* L);
void add_require(lua_State* L);
void add_coroutine(lua_State* L);
void add_math(lua_State* L);
void add_string(lua_State* L);
void add_table(lua_State* L);

/// string.find, match, gmatch and gsub, into the table on top of the stack.
void add_matching(lua_State* L);
/// string.format, into the table on top of the stack.
void add_format(lua_State* L);

}  // namespace shadowlab::lua
