// The globals, apart from the module tables: what stock Lua has and is harmless, and our own of
// what is not.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/sandbox_raise.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

constexpr std::array<std::string_view, 10> stock_functions = {
    "assert", "error",  "getmetatable", "ipairs", "rawequal",
    "rawget", "rawlen", "rawset",       "select", "tonumber"};

int type(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushstring(L, luaL_typename(L, 1));
  return 1;
}

int to_string(lua_State* L) {
  luaL_checkany(L, 1);
  push_text(L, 1);
  return 1;
}

int print(lua_State* L) {
  State& state = State::of(L);
  const int count = lua_gettop(L);
  std::string line;
  for (int i = 1; i <= count; ++i) {
    if (i > 1) line += '\t';
    const std::string_view text = push_text(L, i);
    // One byte more than may be printed shows that it is too much; the rest need not be copied.
    line += text.substr(0, state.limits().printed + 1);
    lua_pop(L, 1);
    if (line.size() > state.limits().printed) break;
  }
  line += '\n';
  state.check_budget(line.size());
  state.print(line);
  return 0;
}

// Lua runs __gc and, after an error in a coroutine, __close with its hooks off: a script that could
// set them could run for ever.
int set_metatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_argexpected(L, lua_isnil(L, 2) || lua_istable(L, 2), 2, "nil or table");
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
    return luaL_error(L, "setmetatable: this table's metatable is locked");
  lua_settop(L, 2);
  if (lua_istable(L, 2))
    for (const char* event : {"__gc", "__close"}) {
      lua_pushstring(L, event);
      if (lua_rawget(L, 2) != LUA_TNIL)
        return luaL_error(L, "setmetatable: %s is not available in a recipe", event);
      lua_pop(L, 1);
    }
  lua_setmetatable(L, 1);
  return 1;
}

// Passes on the results of a protected call, of which the first is at `skipped` + 1, or what it
// failed with; but an exhausted budget is caught by nobody.
int finish_pcall(lua_State* L, int status, lua_KContext skipped) {
  if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L) - static_cast<int>(skipped);
  if (State::of(L).exhausted()) raise_exhausted(L);
  lua_pushboolean(L, 0);
  lua_insert(L, -2);
  return 2;
}

int protected_call(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushboolean(L, 1);
  lua_insert(L, 1);
  const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finish_pcall);
  return finish_pcall(L, status, 0);
}

// The handler runs here, after the stack is unwound: Lua would run it inside the hook that raised,
// where no hook can stop it.
int finish_xpcall(lua_State* L, int status, lua_KContext skipped) {
  if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L) - static_cast<int>(skipped);
  if (State::of(L).exhausted()) raise_exhausted(L);
  lua_pushvalue(L, 2);
  lua_insert(L, -2);
  lua_pcall(L, 1, 1, 0);
  if (State::of(L).exhausted()) raise_exhausted(L);
  lua_pushboolean(L, 0);
  lua_insert(L, -2);
  return 2;
}

int protected_call_with_handler(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const int arguments = lua_gettop(L) - 2;
  lua_pushboolean(L, 1);
  lua_pushvalue(L, 1);
  lua_rotate(L, 3, 2);  // function, handler, true, function, arguments
  const int status = lua_pcallk(L, arguments, LUA_MULTRET, 0, 2, finish_xpcall);
  return finish_xpcall(L, status, 2);
}

constexpr luaL_Reg own_functions[] = {
    {"print", guarded<print>},
    {"pcall", guarded<protected_call>},
    {"setmetatable", guarded<set_metatable>},
    {"tostring", guarded<to_string>},
    {"type", guarded<type>},
    {"xpcall", guarded<protected_call_with_handler>},
    {nullptr, nullptr},
};

}  // namespace

void add_base(lua_State* L) {
  lua_pushcfunction(L, luaopen_base);  // fills the table of globals
  lua_call(L, 0, 0);
  lua_pushglobaltable(L);
  lua_createtable(L, 0, 32);
  for (const std::string_view name : stock_functions) {
    lua_getfield(L, -2, name.data());
    lua_setfield(L, -2, name.data());
  }
  lua_getfield(L, -2, "_VERSION");
  lua_setfield(L, -2, "_VERSION");
  lua_pushvalue(L, -1);
  lua_setfield(L, -2, "_G");
  luaL_setfuncs(L, own_functions, 0);
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_pop(L, 1);
}

int open_libraries(lua_State* L) {
  add_base(L);
  add_pairs(L);
  add_require(L);
  add_coroutine(L);
  add_math(L);
  add_string(L);
  add_table(L);
  lua_pushcfunction(L, luaopen_utf8);
  lua_call(L, 0, 1);
  refuse_unknown_names(L, -1, "utf8");
  lua_setglobal(L, "utf8");
  lua_pushglobaltable(L);
  refuse_unknown_names(L, -1, "");
  return 0;
}

}  // namespace shadowlab::lua
