// What the functions of maps are given and give alike.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lua/boxes.h"
#include "shadow/light_view.h"

namespace shadowlab::lua {

/// Calls visit(name) for each entry of the table of options at `index`, if there is one, with its
/// value on top of the stack. Throws InputError for a name that is none of `names`.
template <class Visit>
void each_option(lua_State* L, int index, const char* function,
                 std::span<const std::string_view> names, Visit visit) {
  if (lua_isnoneornil(L, index)) return;
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError(fmt::format("argument {} of shadow.{} must be a table of options; it is {}",
                                 index, function, describe(L, index)));
  }
  lua_pushnil(L);
  while (lua_next(L, index)) {
    const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(names.begin(), names.end(), key) == names.end()) {
      throw InputError(
          fmt::format("shadow.{} has no option {}{}", function, key, did_you_mean(key, names)));
    }
    visit(std::string_view(key));
    lua_pop(L, 1);
  }
}

inline double number_option(lua_State* L, std::string_view name) {
  return read<double>(L, lua_gettop(L), std::string(name).c_str());
}

/// Whether the value on top is the first of two words. Throws InputError for any other.
inline bool is_first_of(lua_State* L, std::string_view option, std::string_view first,
                        std::string_view second) {
  const std::string_view word = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  if (word == first || word == second) return word == first;
  throw InputError(
      fmt::format("{} is \"{}\" or \"{}\"; it is {}", option, first, second, describe(L, -1)));
}

inline glm::dvec4 light_argument(lua_State* L, int index, const char* function) {
  return read_light(L, index, fmt::format("argument {} of shadow.{} (the light)", index, function))
      .position;
}

inline SceneBox& scene_argument(lua_State* L, int index, const char* function) {
  return read_box<SceneBox>(
      L, index, fmt::format("argument {} of shadow.{} (the scene)", index, function).c_str());
}

inline int integer_argument(lua_State* L, int index, const char* function, int least, int most) {
  const double value =
      read<double>(L, index, fmt::format("argument {} of shadow.{}", index, function).c_str());
  if (value != std::floor(value) || value < least || value > most) {
    throw InputError(fmt::format("argument {} of shadow.{} must be a whole number from {} to {}",
                                 index, function, least, most));
  }
  return static_cast<int>(value);
}

inline void set_number(lua_State* L, const char* name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

/// Pushes a table { view = , projection = }.
inline void push_view(lua_State* L, const shadow::LightView& view) {
  lua_newtable(L);
  push(L, view.view);
  lua_setfield(L, -2, "view");
  push(L, view.projection);
  lua_setfield(L, -2, "projection");
}

}  // namespace shadowlab::lua
