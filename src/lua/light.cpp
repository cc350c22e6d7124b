// Lights as recipes write them.
#include <fmt/format.h>

#include "lua/boxes.h"

namespace shadowlab::lua {
namespace {

template <class T>
std::optional<T> field(lua_State* L, int table, const char* name, const std::string& what) {
  lua_getfield(L, table, name);
  std::optional<T> value;
  if (!lua_isnil(L, -1)) value = read<T>(L, -1, (what + "." + name).c_str());
  lua_pop(L, 1);
  return value;
}

bool is_area(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TTABLE) return false;
  lua_getfield(L, index, "center");
  const bool area = !lua_isnil(L, -1);
  lua_pop(L, 1);
  return area;
}

}  // namespace

scene::Light read_light(lua_State* L, int index, const char* name) {
  scene::Light light;
  if (!is_area(L, index)) {
    light.position = read<glm::dvec4>(L, index, name);
    if (!(light.position.w >= 0))
      throw InputError(std::string(name) +
                       " has w < 0; a light has w = 1 (a point) or 0 (a direction toward it)");
    return light;
  }
  const std::string what = name;
  light.position = glm::dvec4(*field<glm::dvec3>(L, index, "center", what), 1);
  if (const auto radius = field<double>(L, index, "radius", what)) {
    if (!(*radius >= 0)) throw InputError(what + ".radius must not be negative");
    light.shape = scene::Light::Shape::sphere;
    light.radius = *radius;
    return light;
  }
  const auto u = field<glm::dvec3>(L, index, "u", what);
  const auto v = field<glm::dvec3>(L, index, "v", what);
  if (!u || !v)
    throw InputError(what + " is an area light: it takes a radius, or the half-axes u and v");
  lua_getfield(L, index, "disk");
  light.shape = lua_toboolean(L, -1) ? scene::Light::Shape::disk : scene::Light::Shape::rectangle;
  lua_pop(L, 1);
  light.half_u = *u;
  light.half_v = *v;
  return light;
}

void push_light(lua_State* L, const scene::Light& light) {
  if (light.shape == scene::Light::Shape::point) {
    push(L, light.position);
    return;
  }
  lua_newtable(L);
  push(L, glm::dvec3(light.position));
  lua_setfield(L, -2, "center");
  if (light.shape == scene::Light::Shape::sphere) {
    lua_pushnumber(L, light.radius);
    lua_setfield(L, -2, "radius");
    return;
  }
  push(L, light.half_u);
  lua_setfield(L, -2, "u");
  push(L, light.half_v);
  lua_setfield(L, -2, "v");
  lua_pushboolean(L, light.shape == scene::Light::Shape::disk);
  lua_setfield(L, -2, "disk");
}

}  // namespace shadowlab::lua
