// The arguments of the functions of the values' modules, and how those functions refuse them.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "core/error.h"
#include "lua/value.h"

namespace shadowlab::lua {

/// A function as messages name it: "mat4.look_at".
struct Function {
  Kind kind;
  const char* name;

  std::string text() const { return std::string(lua::name(kind)) + "." + name; }
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(text() + ": " + why); }
};

/// Argument `index` of the function. Throws InputError as `read` does.
template <class T>
T argument(lua_State* L, int index, const Function& function) {
  if (const T* value = test<T>(L, index)) return *value;
  const std::string what = "argument " + std::to_string(index) + " of " + function.text();
  return read<T>(L, index, what.c_str());
}

template <>
inline double argument<double>(lua_State* L, int index, const Function& function) {
  if (lua_type(L, index) == LUA_TNUMBER) return lua_tonumber(L, index);
  const std::string what = "argument " + std::to_string(index) + " of " + function.text();
  return read<double>(L, index, what.c_str());
}

/// Argument 1 of a metamethod, without a copy. Throws InputError if it is not a T.
template <class T>
const T& self(lua_State* L) {
  if (const T* value = test<T>(L, 1)) return *value;
  throw InputError("this is not a " + std::string(name(KindOf<T>::value)) + "; it is " +
                   describe(L, 1));
}

/// A vector given as one argument, or as three numbers from `index` on.
inline glm::dvec3 vector_argument(lua_State* L, int index, const Function& function) {
  if (lua_type(L, index) != LUA_TNUMBER) return argument<glm::dvec3>(L, index, function);
  return {argument<double>(L, index, function), argument<double>(L, index + 1, function),
          argument<double>(L, index + 2, function)};
}

/// The numbers of arguments `first` to the last, those of vectors one after the other, into `out`.
/// Throws InputError where they are not exactly as many as `out` holds.
void gather(lua_State* L, int first, const char* constructor, std::span<double> out);

/// What __index and __newindex were asked for, cut short where a script made it long.
std::string field_name(lua_State* L, int index);

/// The functions of the module, for "did you mean".
std::vector<std::string_view> function_names(Kind kind);

/// The tail of every __index: pushes the method that argument 2 names (from the module, upvalue 1).
/// Throws InputError with the nearest name where there is none.
int index_method(lua_State* L, Kind kind);

/// Every __newindex: a value never changes. Throws InputError.
template <Kind kind>
int refuse_assignment(lua_State* L) {
  const std::string what = name(kind);
  throw InputError("a " + what + " cannot be changed, so " + field_name(L, 2) +
                   " cannot be assigned; build a new " + what + " instead");
}

/// The shortest decimal that reads back as the same number; "inf", "-inf", "nan", and 0 for -0.
std::string text(double number);

/// The numbers of a value in memory order: matrices column by column, quaternions x, y, z, w.
template <class T>
std::span<const double> numbers(const T& value) {
  return {glm::value_ptr(value), sizeof(T) / sizeof(double)};
}

/// "vec3(1, 2.5, 3)": a constructor and its numbers, as a script would write them.
std::string call_text(const char* constructor, std::span<const double> numbers);

/// The power of two below the largest component, by which dividing is exact; 1 where that component
/// is 0 or not finite.
template <class T>
double binade(const T& value) {
  double largest = 0;
  for (const double number : numbers(value)) largest = std::fmax(largest, std::fabs(number));
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

/// The length of a vector or quaternion, without overflow or underflow on the way.
template <class T>
double length_of(const T& value) {
  const double scale = binade(value);
  const T scaled = value / scale;
  return scale * std::sqrt(glm::dot(scaled, scaled));
}

/// The vector or quaternion of length 1. Throws InputError, from `function`, where `value` has no
/// direction; `what` is the value in that sentence: "the axis".
template <class T>
T unit(const T& value, const Function& function, const char* what) {
  const T scaled = value / binade(value);
  const double length = std::sqrt(glm::dot(scaled, scaled));
  if (length == 0) function.refuse(std::string(what) + " has length 0, so it has no direction");
  if (!std::isfinite(length)) {
    function.refuse(std::string(what) + " has length " + text(length) +
                    ", so it has no direction; make its components finite");
  }
  return scaled / length;
}

}  // namespace shadowlab::lua
