// What a recipe's table says: its description, parameters and keys.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "lua/value.h"
#include "recipe/recipe.h"
#include "recipe/sweep.h"

namespace shadowlab::recipe {
namespace {

std::string text_field(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

}  // namespace

void Recipe::read_table() {
  lua_State* L = state_.raw();
  if (lua_type(L, -1) != LUA_TTABLE) {
    throw InputError(
        fmt::format("{}: a recipe returns a table with a function draw; this file returns {}",
                    file_.string(), lua::describe(L, -1)));
  }
  const int table = lua_gettop(L);
  lua_getfield(L, table, "draw");
  if (!lua_isfunction(L, -1)) {
    throw InputError(
        fmt::format("{}: the recipe has no function draw; write function recipe.draw(r) … end",
                    file_.string()));
  }
  lua_pop(L, 1);
  description_ = {text_field(L, table, "title"),
                  text_field(L, table, "lecture"),
                  text_field(L, table, "scene"),
                  text_field(L, table, "truth"),
                  {}};
  if (description_.title.empty()) description_.title = file_.stem().string();
  read_parameters(table);
  description_.sweep = read_sweep(L, table, file_.string(), parameters_);
  read_keys(table);
  table_ = luaL_ref(L, LUA_REGISTRYINDEX);
  lua_newtable(L);
  lua_newtable(L);
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, look_up_in_context, 1);
  lua_setfield(L, -2, "__index");
  lua::lock_metatable(L, lua_gettop(L));
  lua_setmetatable(L, -2);
  context_ = luaL_ref(L, LUA_REGISTRYINDEX);
}

void Recipe::read_parameters(int table) {
  lua_State* L = state_.raw();
  lua_getfield(L, table, "params");
  if (lua_type(L, -1) == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      const std::string name =
          lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : lua::describe(L, -2);
      const auto* parameter = lua::test_box<lua::Parameter>(L, -1);
      if (!parameter) {
        throw InputError(fmt::format(
            "{}: params.{} must be made by param.point, param.number and their like; it is {}",
            file_.string(), name, lua::describe(L, -1)));
      }
      parameters_.push_back({name, *parameter});
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    throw InputError(
        fmt::format("{}: params must be a table; it is {}", file_.string(), lua::describe(L, -1)));
  }
  lua_pop(L, 1);
  std::sort(parameters_.begin(), parameters_.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
}

void Recipe::read_keys(int table) {
  lua_State* L = state_.raw();
  lua_getfield(L, table, "keys");
  if (lua_type(L, -1) == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      const bool named = lua_type(L, -2) == LUA_TSTRING && lua_rawlen(L, -2) == 1;
      if (!named || lua_type(L, -1) != LUA_TSTRING) {
        throw InputError(fmt::format(
            "{}: keys is a table of characters and what they do, as s = \"toggle clip\"",
            file_.string()));
      }
      try {
        keys_.push_back(key_action(lua_tostring(L, -2), lua_tostring(L, -1), parameters_));
      } catch (const InputError& problem) {
        throw InputError(file_.string() + ": " + problem.what());
      }
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    throw InputError(
        fmt::format("{}: keys must be a table; it is {}", file_.string(), lua::describe(L, -1)));
  }
  lua_pop(L, 1);
  std::sort(keys_.begin(), keys_.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
}

}  // namespace shadowlab::recipe
