// From a line of functions.def to a function that Lua calls.
//
// Argument conversion and checking, the call with its trace, GL's own verdict and the mapping of
// errors are all here, once; a binding of a plain function is its line in the list. Everything is
// checked before GL sees it: number and type of the arguments, the domain of each enumeration, the
// range of integers, finite floats, live objects.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "gl/functions.h"
#include "lua/guard.h"
#include "lua/object.h"
#include "lua/stage.h"

namespace shadowlab::lua {

/// One call from Lua under way: whose argument is wrong, in the end sentence.
struct Call {
  lua_State* L;
  Stage& stage;
  gl::FunctionId function;

  const gl::Functions& gl() const { return stage.graphics.gl; }

  /// Throw InputError: "gl.StencilFunc: argument 1 (func) …".
  [[noreturn]] void wrong_count(int expected) const;
  [[noreturn]] void wrong_count(int least, int most) const;
  [[noreturn]] void wrong_argument(int index, const std::string& takes) const;
  [[noreturn]] void wrong_enum(int index, std::span<const gl::Constant> values) const;
  /// Of element `element` of the table at `index`, whose value is on top of the stack.
  [[noreturn]] void wrong_element(int index, lua_Integer element,
                                  std::span<const gl::Constant> values) const;
  [[noreturn]] void wrong_bits(int index, std::span<const gl::Constant> values) const;
  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void gl_refused(GLenum error) const;

  void expect(int arguments) const {
    if (lua_gettop(L) != arguments) [[unlikely]]
      wrong_count(arguments);
  }
  void expect(int least, int most) const {
    if (lua_gettop(L) < least || lua_gettop(L) > most) [[unlikely]]
      wrong_count(least, most);
  }
  /// After the call: GL's verdict. Costs some 3 ns in software GL.
  void check_error() const {
    if (const GLenum error = gl().GetError.pointer(); error != GL_NO_ERROR) [[unlikely]] {
      gl_refused(error);
    }
  }

  // Lua itself would take "1" for 1.
  bool is_number(int index) const { return lua_type(L, index) == LUA_TNUMBER; }
  lua_Integer integer(int index, lua_Integer least, lua_Integer most, const char* takes) const {
    int is_integer = 0;
    const lua_Integer value = lua_tointegerx(L, index, &is_integer);
    if (!is_integer || !is_number(index) || value < least || value > most) [[unlikely]]
      wrong_argument(index, takes);
    return value;
  }
  double number(int index, double most) const {
    const double value = lua_tonumberx(L, index, nullptr);
    if (!is_number(index) || !(std::abs(value) <= most)) [[unlikely]]
      wrong_argument(index, "a finite number");
    return value;
  }

  /// Argument `index` (1-based) as `Kind` takes it.
  template <class Kind>
  gl::CppOf<Kind> argument(int index) const;

  /// The first arguments, one of each kind, read first to last: so that the first wrong one is
  /// reported.
  template <class... Kinds>
  std::tuple<gl::CppOf<Kinds>...> arguments() const {
    return arguments<Kinds...>(std::index_sequence_for<Kinds...>());
  }

 private:
  template <class... Kinds, std::size_t... I>
  std::tuple<gl::CppOf<Kinds>...> arguments(std::index_sequence<I...>) const {
    return {argument<Kinds>(static_cast<int>(I) + 1)...};
  }
};

template <class Kind>
gl::CppOf<Kind> Call::argument(int index) const {
  using limits = std::numeric_limits<GLint>;
  if constexpr (std::is_base_of_v<gl::EnumKind, Kind>) {
    int is_integer = 0;
    const lua_Integer value = lua_tointegerx(L, index, &is_integer);
    const auto name = static_cast<GLenum>(value);
    if (!is_integer || !is_number(index) || value != name || !gl::is_one_of<Kind>(name))
        [[unlikely]] {
      wrong_enum(index, Kind::values);
    }
    return name;
  } else if constexpr (std::is_base_of_v<gl::BitsKind, Kind>) {
    int is_integer = 0;
    const lua_Integer value = lua_tointegerx(L, index, &is_integer);
    lua_Integer all = 0;
    for (const gl::Constant& bit : Kind::values) all |= bit.value;
    if (!is_integer || !is_number(index) || (value & ~all) != 0) [[unlikely]]
      wrong_bits(index, Kind::values);
    return static_cast<GLbitfield>(value);
  } else if constexpr (std::is_base_of_v<gl::ObjectKind, Kind>) {
    return read_object(*this, index, gl::object_type<Kind>);
  } else if constexpr (std::is_same_v<Kind, gl::Int> || std::is_same_v<Kind, gl::ParameterValue>) {
    return static_cast<GLint>(integer(index, limits::min(), limits::max(), "an integer"));
  } else if constexpr (std::is_same_v<Kind, gl::Uint>) {
    return static_cast<GLuint>(
        integer(index, 0, 0xFFFFFFFFll, "an integer of 32 bits that is not negative"));
  } else if constexpr (std::is_same_v<Kind, gl::Size>) {
    return static_cast<GLsizei>(
        integer(index, 0, limits::max(), "a size: an integer that is not negative"));
  } else if constexpr (std::is_same_v<Kind, gl::ByteCount> || std::is_same_v<Kind, gl::Offset>) {
    return integer(index, 0, limits::max(), "a number of bytes");
  } else if constexpr (std::is_same_v<Kind, gl::Mask>) {
    // ~0 is -1 in Lua and all ones in C.
    return static_cast<GLuint>(
        integer(index, limits::min(), 0xFFFFFFFFll, "a mask: an integer of 32 bits"));
  } else if constexpr (std::is_same_v<Kind, gl::Bool>) {
    if (lua_isboolean(L, index)) return static_cast<GLboolean>(lua_toboolean(L, index));
    return static_cast<GLboolean>(integer(index, 0, 1, "true, false, gl.TRUE or gl.FALSE"));
  } else if constexpr (std::is_same_v<Kind, gl::Float>) {
    return static_cast<GLfloat>(number(index, std::numeric_limits<GLfloat>::max()));
  } else if constexpr (std::is_same_v<Kind, gl::Double>) {
    return number(index, std::numeric_limits<GLdouble>::max());
  } else if constexpr (std::is_same_v<Kind, gl::Text>) {
    std::size_t length = 0;
    const char* text =
        lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &length) : nullptr;
    if (!text || std::char_traits<char>::length(text) != length) wrong_argument(index, "a name");
    return text;
  } else {
    static_assert(sizeof(Kind) == 0, "functions with this kind of argument are bound by hand");
  }
}

template <class Result>
int push_result(lua_State* L, gl::RawOf<Result> value) {
  if constexpr (std::is_same_v<Result, gl::Bool>) {
    lua_pushboolean(L, value);
  } else {
    lua_pushinteger(L, static_cast<lua_Integer>(value));
  }
  return 1;
}

/// The stage of a function of gl.*: its first upvalue.
inline Stage& stage_of_function(lua_State* L) {
  return *static_cast<Stage*>(lua_touserdata(L, lua_upvalueindex(1)));
}

/// Throws InputError where this context lacks the function.
[[noreturn]] void not_in_this_context(const Call& call);

namespace bind {

struct Skip {
  template <class... Arguments>
  void operator()(const Call&, const Arguments&...) const {}
};

template <class Function>
struct Of;

template <gl::FunctionId Id, class Result, class... Kinds>
struct Of<gl::Function<Id, Result, Kinds...>> {
  template <auto Before, auto After>
  static int run(const Call& call, const gl::Function<Id, Result, Kinds...>& function) {
    call.expect(sizeof...(Kinds));
    if (!function) [[unlikely]]
      not_in_this_context(call);
    return std::apply(
        [&](const auto&... arguments) {
          Before(call, arguments...);
          if constexpr (gl::sets_uniform(Id)) call.stage.graphics.calls().foreign_uniforms++;
          if constexpr (std::is_void_v<gl::RawOf<Result>>) {
            function(arguments...);
            call.check_error();
            After(call, arguments...);
            return 0;
          } else {
            const auto result = function(arguments...);
            call.check_error();
            return push_result<Result>(call.L, result);
          }
        },
        call.arguments<Kinds...>());
  }
};

/// gl.NAME for a function of the table, `Member` its place there. With the arguments, already read,
/// `Before` throws where the function has a condition of its own; `After` is told that GL took
/// them.
template <auto Member, auto Before = Skip(), auto After = Skip()>
int plain(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  return Of<Function>::template run<Before, After>(call, call.gl().*Member);
}

}  // namespace bind
}  // namespace shadowlab::lua
