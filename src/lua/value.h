// vec2, vec3, vec4, mat3, mat4 and quat as Lua values: double precision, full userdata that a
// script can read but never change, so that a value means the same wherever it is passed.
//
// Components may be infinite or not a number here, as in any arithmetic; whatever uploads them to
// GL refuses them there.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <lua.hpp>

#include "lua/entry.h"

namespace shadowlab::lua {

enum class Kind { vec2, vec3, vec4, mat3, mat4, quat };
inline constexpr int kind_count = 6;

template <class T>
struct KindOf;
template <>
struct KindOf<glm::dvec2> : std::integral_constant<Kind, Kind::vec2> {};
template <>
struct KindOf<glm::dvec3> : std::integral_constant<Kind, Kind::vec3> {};
template <>
struct KindOf<glm::dvec4> : std::integral_constant<Kind, Kind::vec4> {};
template <>
struct KindOf<glm::dmat3> : std::integral_constant<Kind, Kind::mat3> {};
template <>
struct KindOf<glm::dmat4> : std::integral_constant<Kind, Kind::mat4> {};
template <>
struct KindOf<glm::dquat> : std::integral_constant<Kind, Kind::quat> {};

/// The name of the kind in Lua: "vec3".
const char* name(Kind kind);

/// The documentation of the values' modules, in the order of Kind.
std::array<Module, kind_count> value_modules();

/// Makes the globals vec2 … quat and their metatables. Call it once for a state, before the
/// functions below, and protected (lua_pcall), since it allocates.
void open_values(lua_State* L);

void push(lua_State* L, const glm::dvec2& value);
void push(lua_State* L, const glm::dvec3& value);
void push(lua_State* L, const glm::dvec4& value);
void push(lua_State* L, const glm::dmat3& value);
void push(lua_State* L, const glm::dmat4& value);
void push(lua_State* L, const glm::dquat& value);

/// Which of the values is at `index`; nothing if it is none of them. Never raises.
std::optional<Kind> kind_of(lua_State* L, int index);

/// The value at `index`, valid while Lua keeps it alive; nullptr if it is not a T. Never raises.
template <class T>
const T* test(lua_State* L, int index) {
  if (kind_of(L, index) != KindOf<T>::value) return nullptr;
  return static_cast<const T*>(lua_touserdata(L, index));
}

/// The value at `index`: a T, or a plain table of exactly its numbers. Vectors: {0, 4, 0} or
/// {x = 0, y = 4, z = 0}; quat: {w, x, y, z} or by name; matrices: column by column. Metamethods of
/// the table are not called. T may be double too, which takes a number and no string. Throws
/// InputError: "WHAT must be a vec3, or a table of 3 numbers; it is a string".
template <class T>
T read(lua_State* L, int index, const char* what);
template <>
double read<double>(lua_State* L, int index, const char* what);

/// What is at `index`, for the end of a sentence: "a string", "a mesh", "nil", "missing".
std::string describe(lua_State* L, int index);

}  // namespace shadowlab::lua
