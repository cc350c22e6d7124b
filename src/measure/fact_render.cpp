#include "measure/fact_render.h"

#include <fmt/format.h>

#include "core/error.h"
#include "recipe/recipe.h"

namespace shadowlab::measure {
namespace {

// A parameter's value as --set takes it.
std::string setting(lua_State* L, int index) {
  if (const auto* v = lua::test<glm::dvec3>(L, index))
    return fmt::format("{},{},{}", v->x, v->y, v->z);
  if (lua_type(L, index) == LUA_TNUMBER) return fmt::format("{}", lua_tonumber(L, index));
  std::string text(lua::push_text(L, index));
  lua_pop(L, 1);
  return text;
}

void read_settings(lua_State* L, int table, RenderOptions& options) {
  lua_pushnil(L);
  while (lua_next(L, table)) {
    options.settings.emplace_back(luaL_checkstring(L, -2), setting(L, lua_gettop(L)));
    lua_pop(L, 1);
  }
}

// The option `name` with the value on top of the stack.
void read_option(lua_State* L, const std::string& name, RenderOptions& options) {
  const int value = lua_gettop(L);
  if (name == "size") {
    const auto size = lua::read<glm::dvec2>(L, value, "size");
    options.width = static_cast<int>(size.x);
    options.height = static_cast<int>(size.y);
  } else if (name == "scene") {
    options.scene = luaL_checkstring(L, value);
  } else if (name == "set") {
    luaL_checktype(L, value, LUA_TTABLE);
    read_settings(L, value, options);
  } else if (name == "frames") {
    options.frames = static_cast<int>(luaL_checkinteger(L, value));
  } else if (name == "time") {
    options.time = lua::read<double>(L, value, "time");
  } else if (name == "visibility") {
    options.visibility = lua_toboolean(L, value);
  } else {
    throw InputError(fmt::format("render has no option {}", name));
  }
}

}  // namespace

RenderOptions read_render_options(lua_State* L, int index) {
  RenderOptions options;
  if (lua_isnoneornil(L, index)) return options;
  luaL_checktype(L, index, LUA_TTABLE);
  lua_pushnil(L);
  while (lua_next(L, index)) {
    read_option(L, luaL_checkstring(L, -2), options);
    lua_pop(L, 1);
  }
  return options;
}

Frame render(gl::Graphics& graphics, const std::filesystem::path& file,
             const RenderOptions& options) {
  recipe::Options recipe_options;
  recipe_options.scene = options.scene;
  if (options.visibility) recipe_options.shading = recipe::Options::Shading::visibility;
  graphics.context().make_current();
  recipe::Recipe recipe(graphics, file, recipe_options);
  for (const auto& [name, value] : options.settings) recipe.set(name, value);
  Frame frame;
  for (int i = 0; i < options.frames; ++i) {
    if (i + 1 == options.frames) {
      recipe.on_pass_end([&](std::size_t pass) {
        frame.push_back(
            look_at(graphics.frame, options.width, options.height, recipe.passes()[pass].name));
      });
    }
    recipe.draw(options.time + i / 60.0);
  }
  frame.push_back(look_at(graphics.frame, options.width, options.height, ""));
  return frame;
}

}  // namespace shadowlab::measure
