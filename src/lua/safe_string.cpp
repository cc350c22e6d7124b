// string: stock Lua's functions where they are harmless. dump, pack, packsize and unpack are not
// here: they read or write compiled code and raw bytes.
#include <algorithm>
#include <cstring>
#include <string_view>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

int rep(lua_State* L) {
  std::size_t length = 0, separator_length = 0;
  const char* text = luaL_checklstring(L, 1, &length);
  const lua_Integer times = luaL_checkinteger(L, 2);
  const char* separator = luaL_optlstring(L, 3, "", &separator_length);
  const std::size_t step = length + separator_length;
  if (times <= 0 || step == 0) {
    lua_pushliteral(L, "");
    return 1;
  }
  const auto count = static_cast<std::size_t>(times);
  if (count > State::of(L).limits().memory / step)
    throw InputError("string.rep: the text would be longer than the memory that a recipe has");
  const std::size_t total = count * step - separator_length;
  luaL_Buffer result;
  char* const begin = luaL_buffinitsize(L, &result, total);
  // One copy with its separator, then all that is there once more until it is enough.
  std::size_t done = std::min(step, total);
  std::memcpy(begin, text, length);
  std::memcpy(begin + length, separator, done - length);
  while (done < total) {
    const std::size_t more = std::min(done, total - done);
    std::memcpy(begin + done, begin, more);
    done += more;
  }
  luaL_pushresultsize(&result, total);
  return 1;
}

}  // namespace

void add_string(lua_State* L) {
  lua_pushcfunction(L, luaopen_string);
  lua_call(L, 0, 1);
  for (const char* name : {"dump", "pack", "packsize", "unpack"}) {
    lua_pushnil(L);
    lua_setfield(L, -2, name);
  }
  lua_pushcfunction(L, guarded<rep>);
  lua_setfield(L, -2, "rep");
  add_matching(L);
  add_format(L);
  refuse_unknown_names(L, -1, "string");
  // The metatable of strings, whose __index is the table on top.
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lock_metatable(L, -1);
  lua_pop(L, 2);
  lua_setglobal(L, "string");
}

}  // namespace shadowlab::lua
