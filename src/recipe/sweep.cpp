#include "recipe/sweep.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/value.h"

namespace shadowlab::recipe {
namespace {

// A value as --set takes it.
std::string text_of(lua_State* L, int index) {
  if (lua_isboolean(L, index)) return lua_toboolean(L, index) ? "true" : "false";
  return std::string(lua::push_text(L, index));
}

const lua::Parameter& parameter_named(const std::string& name, const std::string& file,
                                      std::span<const NamedParameter> parameters) {
  std::vector<std::string_view> names;
  for (const NamedParameter& known : parameters) {
    if (known.name == name) return known.parameter;
    names.push_back(known.name);
  }
  throw InputError(
      fmt::format("{}: sweep.{} is no parameter{}", file, name, did_you_mean(name, names)));
}

// The values of the list on top of the stack.
std::vector<std::string> values_of(lua_State* L, const std::string& name, const std::string& file,
                                   lua::Parameter parameter) {
  const std::string what = fmt::format("{}: sweep.{}", file, name);
  if (lua_type(L, -1) != LUA_TTABLE || lua_rawlen(L, -1) == 0)
    throw InputError(what + " must be a list of values; it is " + lua::describe(L, -1));
  std::vector<std::string> values;
  const int list = lua_gettop(L);
  for (lua_Unsigned i = 1; i <= lua_rawlen(L, list); ++i) {
    lua_rawgeti(L, list, static_cast<lua_Integer>(i));
    values.push_back(text_of(L, lua_gettop(L)));
    lua_settop(L, list);
    try {
      lua::set_value(parameter, name, values.back());
    } catch (const InputError& problem) {
      throw InputError(what + ": " + problem.what());
    }
  }
  return values;
}

}  // namespace

std::vector<Swept> read_sweep(lua_State* L, int table, const std::string& file,
                              std::span<const NamedParameter> parameters) {
  std::vector<Swept> sweep;
  lua_getfield(L, table, "sweep");
  if (lua_type(L, -1) == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      const std::string name =
          lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : lua::describe(L, -2);
      sweep.push_back({name, values_of(L, name, file, parameter_named(name, file, parameters))});
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    throw InputError(
        fmt::format("{}: sweep must be a table; it is {}", file, lua::describe(L, -1)));
  }
  lua_pop(L, 1);
  std::sort(sweep.begin(), sweep.end(),
            [](const Swept& a, const Swept& b) { return a.name < b.name; });
  return sweep;
}

}  // namespace shadowlab::recipe
