#include "lua/object.h"

#include <fmt/format.h>

#include "core/error.h"
#include "lua/bind.h"
#include "lua/value.h"

namespace shadowlab::lua {
namespace {

constexpr int types = static_cast<int>(gl::ObjectType::query) + 1;
// Addresses that nobody else uses: where the registry keeps each type's metatable.
const char keys[types] = {};

// A script's objects are those of its own stage, so the name says all.
const gl::ObjectName* boxed_at(lua_State* L, int index, gl::ObjectType type) {
  void* memory = lua_touserdata(L, index);
  if (!memory || !lua_getmetatable(L, index)) return nullptr;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &keys[static_cast<int>(type)]);
  const bool same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same ? static_cast<const gl::ObjectName*>(memory) : nullptr;
}

bool is_zero(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TNUMBER && lua_tonumber(L, index) == 0;
}

std::string takes(gl::ObjectType type) {
  const std::string object = gl::title(type);
  return type == gl::ObjectType::framebuffer ? "a framebuffer, or 0 for the main frame"
                                             : "a " + object + ", or 0 for none";
}

int text_of(lua_State* L) {
  const auto* object = static_cast<const gl::ObjectName*>(lua_touserdata(L, 1));
  if (!object) return luaL_error(L, "not a GL object");
  lua_pushfstring(L, "%s %d", gl::title(object->type), static_cast<int>(object->slot) + 1);
  return 1;
}

int same(lua_State* L) {
  for (int type = 0; type < types; ++type) {
    const auto* a = boxed_at(L, 1, static_cast<gl::ObjectType>(type));
    const auto* b = boxed_at(L, 2, static_cast<gl::ObjectType>(type));
    if (a && b) {
      lua_pushboolean(L, *a == *b);
      return 1;
    }
  }
  lua_pushboolean(L, false);
  return 1;
}

}  // namespace

void open_objects(lua_State* L) {
  for (int type = 0; type < types; ++type) {
    lua_newtable(L);
    lua_pushstring(L, gl::title(static_cast<gl::ObjectType>(type)));
    lua_setfield(L, -2, "__name");
    lua_pushcfunction(L, text_of);
    lua_setfield(L, -2, "__tostring");
    lua_pushcfunction(L, same);
    lua_setfield(L, -2, "__eq");
    lock_metatable(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &keys[type]);
  }
}

void push_objects(Stage& stage, lua_State* L, gl::ObjectType type, std::span<const GLuint> names) {
  const auto objects = stage.objects.add(stage.graphics.gl, type, names);
  luaL_checkstack(L, static_cast<int>(names.size()) + 4, "too many objects at once");
  for (const gl::ObjectName& object : objects) {
    new (lua_newuserdatauv(L, sizeof object, 0)) gl::ObjectName(object);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &keys[static_cast<int>(type)]);
    lua_setmetatable(L, -2);
  }
}

std::optional<gl::ObjectName> object_at(const Call& call, int index, gl::ObjectType type) {
  if (is_zero(call.L, index)) return {};
  const gl::ObjectName* object = boxed_at(call.L, index, type);
  if (!object) call.wrong_argument(index, takes(type));
  return *object;
}

GLuint read_object(const Call& call, int index, gl::ObjectType type) {
  const auto name = object_at(call, index, type);
  if (!name) return 0;
  const auto found = call.stage.objects.find(*name);
  if (!found)
    call.refuse(fmt::format("argument {} is a {} that was deleted", index, gl::title(type)));
  return *found;
}

}  // namespace shadowlab::lua
