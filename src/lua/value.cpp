#include "lua/value.h"

#include <algorithm>
#include <new>
#include <string_view>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/arguments.h"
#include "lua/guard.h"

namespace shadowlab::lua {
namespace {

// Their addresses are keys that no script can make: keys[k] finds the metatable of kind k in the
// registry, and keys itself finds the kind in a metatable.
constexpr char keys[kind_count] = {};

constexpr const char* names[kind_count] = {"vec2", "vec3", "vec4", "mat3", "mat4", "quat"};

constexpr int index_of(Kind kind) { return static_cast<int>(kind); }

template <class T>
void push_value(lua_State* L, const T& value) {
  static_assert(alignof(T) <= alignof(lua_Number) && std::is_trivially_destructible_v<T>);
  new (lua_newuserdatauv(L, sizeof(T), 0)) T(value);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &keys[index_of(KindOf<T>::value)]);
  lua_setmetatable(L, -2);
}

template <class T>
constexpr std::string_view letters() {
  if constexpr (std::is_same_v<T, glm::dquat>) return "wxyz";
  if constexpr (std::is_same_v<T, glm::dmat3> || std::is_same_v<T, glm::dmat4>) return "";
  return std::string_view("xyzw").substr(0, sizeof(T) / sizeof(double));
}

template <class T>
T made_of(std::span<const double> numbers) {
  if constexpr (std::is_same_v<T, glm::dquat>) {
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
  } else {
    T value;
    std::ranges::copy(numbers, glm::value_ptr(value));
    return value;
  }
}

/// The table's number of keys, counted no further than `limit`: a script's table may be huge.
std::size_t count_keys(lua_State* L, int table, std::size_t limit) {
  std::size_t count = 0;
  lua_pushnil(L);
  while (count < limit && lua_next(L, table)) {
    lua_pop(L, 1);
    ++count;
  }
  if (count == limit) lua_pop(L, 1);
  return count;
}

/// Fills `out` from the table; otherwise says what the table is instead.
std::optional<std::string> read_table(lua_State* L, int table, std::string_view names_of,
                                      std::span<double> out) {
  const std::size_t count = count_keys(L, table, out.size() + 1);
  if (count > out.size()) return "a table of more than " + std::to_string(out.size()) + " elements";
  if (count < out.size()) {
    return "a table of " + std::to_string(count) + (count == 1 ? " element" : " elements");
  }
  const bool by_name = !names_of.empty() && lua_rawlen(L, table) == 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string element =
        by_name ? std::string(1, names_of[i]) : "element " + std::to_string(i + 1);
    if (by_name) {
      lua_pushlstring(L, &names_of[i], 1);
      lua_rawget(L, table);
    } else {
      lua_rawgeti(L, table, static_cast<lua_Integer>(i) + 1);
    }
    if (lua_type(L, -1) != LUA_TNUMBER) {
      return "a table whose " + element + " is " + describe(L, -1);
    }
    out[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return std::nullopt;
}

void set_text(lua_State* L, const char* field, const char* text) {
  lua_pushstring(L, text);
  lua_setfield(L, -2, field);
}

/// vec3.lenght: reading what a module does not have. Upvalue 1 is the kind.
int unknown_in_module(lua_State* L) {
  const Kind kind = static_cast<Kind>(lua_tointeger(L, lua_upvalueindex(1)));
  const std::string module = name(kind), field = field_name(L, 2);
  const auto nearest = nearest_name(field, function_names(kind));
  throw InputError(
      module + "." + field + " does not exist" +
      (nearest ? "; did you mean " + module + "." + std::string(*nearest) + "?" : std::string()));
}

void open_module(lua_State* L, Kind kind, const Module& module) {
  lua_newtable(L);  // the module
  set_functions(L, module.entries);
  lua_newtable(L);  // the metatable of the values
  lua_newtable(L);  // the metatable of the module
  for (const Entry& entry : module.entries) {
    if (!entry.is_metamethod()) continue;
    const bool of_module = std::string_view(entry.name) == "__call";
    lua_pushvalue(L, -3);
    lua_pushcclosure(L, entry.function, 1);
    lua_setfield(L, of_module ? -2 : -3, entry.name);
  }
  lua_pushinteger(L, index_of(kind));
  lua_pushcclosure(L, guarded<unknown_in_module>, 1);
  lua_setfield(L, -2, "__index");
  set_text(L, "__metatable", "locked");
  lua_setmetatable(L, -3);
  set_text(L, "__name", module.name);
  set_text(L, "__metatable", "locked");
  lua_pushinteger(L, index_of(kind));
  lua_rawsetp(L, -2, keys);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &keys[index_of(kind)]);
  lua_setglobal(L, module.name);
}

}  // namespace

const char* name(Kind kind) { return names[index_of(kind)]; }

std::array<Module, kind_count> value_modules() {
  return {Module{"vec2", "Vectors of 2 numbers in double precision.", vec2_entries()},
          Module{"vec3", "Vectors of 3 numbers in double precision.", vec3_entries()},
          Module{"vec4", "Vectors of 4 numbers in double precision: homogeneous points and planes.",
                 vec4_entries()},
          Module{"mat3", "3×3 matrices in double precision, which multiply column vectors.",
                 mat3_entries()},
          Module{"mat4", "4×4 matrices in double precision, which multiply column vectors.",
                 mat4_entries()},
          Module{"quat", "Quaternions in double precision: rotations.", quat_entries()}};
}

void open_values(lua_State* L) {
  luaL_checkstack(L, 8, nullptr);
  int kind = 0;
  for (const Module& module : value_modules()) open_module(L, static_cast<Kind>(kind++), module);
}

std::optional<Kind> kind_of(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA || !lua_getmetatable(L, index)) return std::nullopt;
  const int type = lua_rawgetp(L, -1, keys);
  const auto kind = static_cast<Kind>(lua_tointeger(L, -1));
  lua_pop(L, 2);
  if (type != LUA_TNUMBER) return std::nullopt;
  return kind;
}

void push(lua_State* L, const glm::dvec2& value) { push_value(L, value); }
void push(lua_State* L, const glm::dvec3& value) { push_value(L, value); }
void push(lua_State* L, const glm::dvec4& value) { push_value(L, value); }
void push(lua_State* L, const glm::dmat3& value) { push_value(L, value); }
void push(lua_State* L, const glm::dmat4& value) { push_value(L, value); }
void push(lua_State* L, const glm::dquat& value) { push_value(L, value); }

std::string describe(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
      return "missing";
    case LUA_TNIL:
      return "nil";
    case LUA_TTHREAD:
      return "a coroutine";
    default:
      break;
  }
  std::string type = luaL_typename(L, index);
  const int named = luaL_getmetafield(L, index, "__name");
  if (named == LUA_TSTRING) type = lua_tostring(L, -1);
  if (named != LUA_TNIL) lua_pop(L, 1);
  return (std::string_view("aeiou").find(type[0]) != std::string_view::npos ? "an " : "a ") + type;
}

template <class T>
T read(lua_State* L, int index, const char* what) {
  if (const T* value = test<T>(L, index)) return *value;
  constexpr std::size_t count = sizeof(T) / sizeof(double);
  std::string found;
  if (lua_type(L, index) == LUA_TTABLE) {
    double numbers[count];
    const auto complaint = read_table(L, lua_absindex(L, index), letters<T>(), numbers);
    if (!complaint) return made_of<T>(numbers);
    found = *complaint;
  } else {
    found = describe(L, index);
  }
  throw InputError(std::string(what) + " must be a " + name(KindOf<T>::value) + ", or a table of " +
                   std::to_string(count) + " numbers; it is " + found);
}

template <>
double read<double>(lua_State* L, int index, const char* what) {
  if (lua_type(L, index) == LUA_TNUMBER) return lua_tonumber(L, index);
  throw InputError(std::string(what) + " must be a number; it is " + describe(L, index));
}

template glm::dvec2 read(lua_State*, int, const char*);
template glm::dvec3 read(lua_State*, int, const char*);
template glm::dvec4 read(lua_State*, int, const char*);
template glm::dmat3 read(lua_State*, int, const char*);
template glm::dmat4 read(lua_State*, int, const char*);
template glm::dquat read(lua_State*, int, const char*);

}  // namespace shadowlab::lua
