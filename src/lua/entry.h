// What a Lua module offers: each function beside its documentation, in one table from which both
// the module and the reference in docs/ are made.
#pragma once

#include <span>

#include <lua.hpp>

namespace shadowlab::lua {

/// A function of a module. A name that begins with "__" is a metamethod (an operator): `__call` is
/// the module itself being called, the others belong to the values that it makes.
struct Entry {
  const char* name;
  const char* signature;  ///< as a script writes it: "v:dot(u)"
  const char* text;       ///< sentences: what it gives, units, what is refused
  lua_CFunction function;

  constexpr bool is_metamethod() const { return name[0] == '_' && name[1] == '_'; }
};

struct Module {
  const char* name;
  const char* text;
  std::span<const Entry> entries;
};

/// Puts the functions, without the metamethods, into the table on top of the stack.
inline void set_functions(lua_State* L, std::span<const Entry> entries) {
  for (const Entry& entry : entries) {
    if (entry.is_metamethod()) continue;
    lua_pushcfunction(L, entry.function);
    lua_setfield(L, -2, entry.name);
  }
}

std::span<const Entry> vec2_entries();
std::span<const Entry> vec3_entries();
std::span<const Entry> vec4_entries();
std::span<const Entry> mat3_entries();
std::span<const Entry> mat4_entries();
std::span<const Entry> quat_entries();

}  // namespace shadowlab::lua
