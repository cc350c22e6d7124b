#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/guard.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// What stock Lua has and a recipe has not.
constexpr std::array withheld = {
    "collectgarbage", "debug",           "dofile",       "getfenv",    "io",
    "load",           "loadfile",        "module",       "loadstring", "os",
    "package",        "setfenv",         "warn",         "unpack",     "string.dump",
    "string.pack",    "string.packsize", "string.unpack"};

// Beyond these, nobody is helped by the nearest name, and it would take long to find.
constexpr std::size_t longest_name = 64;
constexpr std::size_t most_names = 5000;

// Calls `see` with every name that is a key of the table at `index`.
template <class See>
void each_name(lua_State* L, int index, See see) {
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) {
      std::size_t length = 0;
      const char* name = lua_tolstring(L, -2, &length);
      if (length <= longest_name) see(std::string(name, length));
    }
}

// The local variables and upvalues that the function which read the name can see.
template <class See>
void each_variable(lua_State* L, See see) {
  lua_Debug frame;
  if (!lua_getstack(L, 1, &frame)) return;
  for (int i = 1; const char* name = lua_getlocal(L, &frame, i); ++i, lua_pop(L, 1)) see(name);
  lua_getinfo(L, "f", &frame);
  for (int i = 1; const char* name = lua_getupvalue(L, -1, i); ++i, lua_pop(L, 1)) see(name);
  lua_pop(L, 1);
}

// The __index of a strict table; upvalue 1 is the module's name, "" for the globals.
int refuse_name(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  std::size_t length = 0;
  const char* text = lua_tolstring(L, 2, &length);
  const std::string name(text, std::min(length, longest_name));
  const std::string module = lua_tostring(L, lua_upvalueindex(1));
  const std::string prefix = module.empty() ? "" : module + ".";
  if (std::ranges::find(withheld, prefix + name) != withheld.end())
    throw InputError(prefix + name + " is not available in a recipe" +
                     (prefix + name == "unpack" ? "; use table.unpack" : ""));

  std::vector<std::string> names;
  const auto keep = [&](std::string candidate) {
    if (names.size() <= most_names && !candidate.empty() && candidate[0] != '(')
      names.push_back(std::move(candidate));
  };
  if (module.empty()) each_variable(L, keep);
  each_name(L, 1, keep);
  if (length > longest_name || names.size() > most_names) names.clear();
  State::of(L).check_budget(100 * names.size());
  std::ranges::sort(names);  // the order of the table is not the same in every run
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = nearest_name(name, views);
  throw InputError(prefix + name + (module.empty() ? " is not defined" : " does not exist") +
                   (near ? "; did you mean " + prefix + std::string(*near) + "?" : ""));
}

}  // namespace

std::string_view push_text(lua_State* L, int index) {
  index = lua_absindex(L, index);
  luaL_checkstack(L, 4, nullptr);
  if (luaL_callmeta(L, index, "__tostring")) {
    if (!lua_isstring(L, -1)) luaL_error(L, "'__tostring' must return a string");
  } else {
    switch (lua_type(L, index)) {
      case LUA_TNUMBER:
      case LUA_TSTRING:
        lua_pushvalue(L, index);
        break;
      case LUA_TBOOLEAN:
        lua_pushstring(L, lua_toboolean(L, index) ? "true" : "false");
        break;
      case LUA_TNIL:
        lua_pushliteral(L, "nil");
        break;
      default: {
        const int kind = luaL_getmetafield(L, index, "__name");
        if (kind == LUA_TSTRING) break;
        if (kind != LUA_TNIL) lua_pop(L, 1);
        lua_pushstring(L, luaL_typename(L, index));
      }
    }
  }
  std::size_t length = 0;
  const char* text = lua_tolstring(L, -1, &length);
  return {text, length};
}

void refuse_unknown_names(lua_State* L, int index, const char* module) {
  index = lua_absindex(L, index);
  lua_createtable(L, 0, 2);
  lua_pushstring(L, module);
  lua_pushcclosure(L, guarded<refuse_name>, 1);
  lua_setfield(L, -2, "__index");
  lock_metatable(L, -1);
  lua_setmetatable(L, index);
}

void lock_metatable(lua_State* L, int index) {
  index = lua_absindex(L, index);
  lua_pushboolean(L, 0);
  lua_setfield(L, index, "__metatable");
}

}  // namespace shadowlab::lua
