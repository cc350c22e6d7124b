// C++ values as Lua userdata: a metatable for each type, methods, fields, and the destructor.
//
//   template <> struct BoxTraits<Thing> {
//     static constexpr const char* name = "thing";              // what messages call it
//     static bool push_field(lua_State*, Thing&, std::string_view key);   // t.key, or false
//     static std::span<const std::string_view> fields();        // for "did you mean"
//   };
#pragma once

#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/entry.h"
#include "lua/guard.h"
#include "lua/state.h"
#include "lua/value.h"

namespace shadowlab::lua {

template <class T>
struct BoxTraits;

namespace box {

// Its address is where the registry keeps the metatable of T.
template <class T>
inline const char key = 0;

template <class T>
int destroy(lua_State* L) {
  std::destroy_at(static_cast<T*>(lua_touserdata(L, 1)));
  return 0;
}

template <class T>
int text(lua_State* L) {
  lua_pushstring(L, BoxTraits<T>::name);
  return 1;
}

template <class T>
int index(lua_State* L) {
  T& self = *static_cast<T*>(lua_touserdata(L, 1));
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  lua_pop(L, 1);
  const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : describe(L, 2);
  if (BoxTraits<T>::push_field(L, self, key)) return 1;
  std::vector<std::string> methods;
  lua_pushnil(L);
  while (lua_next(L, lua_upvalueindex(1))) {
    methods.emplace_back(lua_tostring(L, -2));
    lua_pop(L, 1);
  }
  std::vector<std::string_view> names(methods.begin(), methods.end());
  for (const auto field : BoxTraits<T>::fields()) names.push_back(field);
  throw InputError(std::string("a ") + BoxTraits<T>::name + " has no " + key +
                   did_you_mean(key, names));
}

template <class T>
int assign(lua_State* L) {
  const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : describe(L, 2);
  throw InputError(std::string("a ") + BoxTraits<T>::name + " cannot be changed, so " + key +
                   " cannot be assigned");
}

}  // namespace box

/// Makes T's metatable with these methods; once for a state.
template <class T>
void open_box(lua_State* L, std::span<const Entry> methods) {
  lua_newtable(L);
  lua_pushstring(L, BoxTraits<T>::name);
  lua_setfield(L, -2, "__name");
  lua_pushcfunction(L, box::destroy<T>);
  lua_setfield(L, -2, "__gc");
  lua_pushcfunction(L, box::text<T>);
  lua_setfield(L, -2, "__tostring");
  lua_newtable(L);
  set_functions(L, methods);
  lua_pushcclosure(L, guarded<box::index<T>>, 1);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<box::assign<T>>);
  lua_setfield(L, -2, "__newindex");
  lock_metatable(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &box::key<T>);
}

/// Pushes `value`; returns where it now lives, valid while Lua keeps it.
template <class T>
T& push_box(lua_State* L, T value) {
  void* memory = lua_newuserdatauv(L, sizeof(T), 0);
  T* boxed = new (memory) T(std::move(value));
  lua_rawgetp(L, LUA_REGISTRYINDEX, &box::key<T>);
  lua_setmetatable(L, -2);
  return *boxed;
}

/// The T at `index`, or nullptr.
template <class T>
T* test_box(lua_State* L, int index) {
  void* memory = lua_touserdata(L, index);
  if (!memory || !lua_getmetatable(L, index)) return nullptr;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &box::key<T>);
  const bool same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same ? static_cast<T*>(memory) : nullptr;
}

/// The T at `index`. Throws InputError: "WHAT must be a mesh; it is a number".
template <class T>
T& read_box(lua_State* L, int index, std::string_view what) {
  if (T* value = test_box<T>(L, index)) return *value;
  throw InputError(std::string(what) + " must be a " + BoxTraits<T>::name + "; it is " +
                   describe(L, index));
}

}  // namespace shadowlab::lua
