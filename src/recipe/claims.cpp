// What a recipe says of its own technique: where it holds, how far it may depart, what it averages.
#include <fmt/format.h>

#include <map>

#include "core/error.h"
#include "lua/value.h"
#include "recipe/recipe.h"

namespace shadowlab::recipe {

// Calls the recipe's function of that name, if it has one, and lets `take` have what it gives, on
// top of the stack.
void Recipe::ask(const char* name, const std::function<void(lua_State*)>& take) {
  state_.restart_budget();
  state_.run([&](lua_State* L) {
    if (!push_function(name)) return;
    push_context(0);
    lua_call(L, 1, 1);
    take(L);
  });
}

bool Recipe::holds() {
  bool holds = true;
  ask("holds", [&](lua_State* L) { holds = lua_toboolean(L, -1); });
  return holds;
}

Limit Recipe::limit() {
  Limit limit;
  const std::map<std::string_view, double*> fields{
      {"eye_units", &limit.eye_units},     {"across", &limit.across},
      {"on_receiver", &limit.on_receiver}, {"light_units", &limit.light_units},
      {"light_near", &limit.light_near},   {"light_range", &limit.light_range}};
  ask("limit", [&](lua_State* L) {
    if (lua_type(L, -1) != LUA_TTABLE)
      throw InputError(fmt::format("{}: limit gives no table", file_.string()));
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
      const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
      const auto field = fields.find(name);
      if (field == fields.end() || lua_type(L, -1) != LUA_TNUMBER) {
        throw InputError(fmt::format("{}: limit gives no number \"{}\"", file_.string(), name));
      }
      *field->second = lua_tonumber(L, -1);
    }
  });
  return limit;
}

std::vector<glm::dvec4> Recipe::points() {
  std::vector<glm::dvec4> points;
  ask("points", [&](lua_State* L) {
    if (lua_type(L, -1) != LUA_TTABLE)
      throw InputError(fmt::format("{}: points gives no list of points", file_.string()));
    for (lua_Integer i = 1; lua_geti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1))
      points.push_back(lua::read<glm::dvec4>(L, lua_gettop(L), "a point of the recipe's points"));
  });
  return points;
}

}  // namespace shadowlab::recipe
