#include "lua/bind.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/value.h"

namespace shadowlab::lua {
namespace {

// How a message shows what was given: gl.KEEP for a number that is a constant, "7", "a string".
std::string given(lua_State* L, int index, bool as_constant) {
  if (lua_type(L, index) != LUA_TNUMBER) return describe(L, index);
  if (as_constant && lua_isinteger(L, index)) {
    const lua_Integer value = lua_tointeger(L, index);
    // Small numbers are counts, levels and primitives: too many things to be named.
    for (const gl::Constant& constant : gl::all_constants()) {
      if (value >= 0x100 && static_cast<lua_Integer>(constant.value) == value) {
        return fmt::format("gl.{}", constant.name);
      }
    }
  }
  return std::string(push_text(L, index));
}

std::string listed(std::span<const gl::Constant> values, std::string_view separator) {
  constexpr std::size_t most = 24;
  std::string list;
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i) {
    list += fmt::format("{}gl.{}", i ? separator : "", values[i].name);
  }
  if (values.size() > most) list += fmt::format(" and {} more", values.size() - most);
  return list;
}

std::vector<std::string_view> names_of(std::span<const gl::Constant> values) {
  std::vector<std::string_view> names;
  for (const gl::Constant& value : values) names.push_back(value.name);
  return names;
}

// "must be one of gl.A, gl.B; it is gl.C; did you mean gl.B?"
std::string not_one_of(lua_State* L, int index, std::span<const gl::Constant> values) {
  const auto names = names_of(values);
  std::string hint;
  const std::string what = given(L, index, true);
  if (what.starts_with("gl.")) {
    if (const auto near = nearest_name(std::string_view(what).substr(3), names)) {
      hint = fmt::format("; did you mean gl.{}?", *near);
    }
  } else if (lua_type(L, index) == LUA_TSTRING) {
    std::string_view text = lua_tostring(L, index);
    if (text.starts_with("GL_")) text.remove_prefix(3);
    const auto near = nearest_name(text, names);
    if (near) hint = fmt::format("; write gl.{}", *near);
  }
  return fmt::format("must be {}{}; it is {}{}", values.size() > 1 ? "one of " : "",
                     listed(values, ", "), what, hint);
}

}  // namespace

void Call::refuse(const std::string& why) const {
  throw InputError(fmt::format("gl.{}: {}", gl::describe(function).name, why));
}

void Call::wrong_count(int expected) const { wrong_count(expected, expected); }

void Call::wrong_count(int least, int most) const {
  const auto& description = gl::describe(function);
  const std::string expected =
      least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  refuse(fmt::format("takes {} argument{} ({}); {} given", expected, expected == "1" ? "" : "s",
                     most == 0 ? "none" : std::string(description.parameters), lua_gettop(L)));
}

void Call::wrong_argument(int index, const std::string& takes) const {
  const auto& description = gl::describe(function);
  const auto number = static_cast<std::size_t>(index);
  const std::string name = number <= description.arity
                               ? fmt::format(" ({})", gl::parameter_name(description, number - 1))
                               : "";
  refuse(
      fmt::format("argument {}{} must be {}; it is {}", index, name, takes, given(L, index, true)));
}

void Call::wrong_enum(int index, std::span<const gl::Constant> values) const {
  refuse(
      fmt::format("argument {} ({}) {}", index,
                  gl::parameter_name(gl::describe(function), static_cast<std::size_t>(index) - 1),
                  not_one_of(L, index, values)));
}

void Call::wrong_element(int index, lua_Integer element,
                         std::span<const gl::Constant> values) const {
  refuse(
      fmt::format("element {} of argument {} ({}) {}", element, index,
                  gl::parameter_name(gl::describe(function), static_cast<std::size_t>(index) - 1),
                  not_one_of(L, lua_gettop(L), values)));
}

void Call::wrong_bits(int index, std::span<const gl::Constant> values) const {
  wrong_argument(index, "an OR of " + listed(values, " | "));
}

void Call::gl_refused(GLenum error) const {
  std::string why;
  switch (error) {
    case GL_INVALID_ENUM:
      why = "this combination of names is not allowed here";
      break;
    case GL_INVALID_VALUE:
      why = "a number is out of the range that GL allows";
      break;
    case GL_INVALID_OPERATION:
      why = "GL does not allow this in its present state";
      break;
    case GL_INVALID_FRAMEBUFFER_OPERATION: {
      const GLenum status = gl().CheckFramebufferStatus.unrecorded(GL_DRAW_FRAMEBUFFER);
      why = fmt::format("the framebuffer is not complete (gl.{})",
                        gl::name_of<gl::FramebufferStatus>(status));
      break;
    }
    case GL_OUT_OF_MEMORY:
      why = "GL is out of memory";
      break;
    default:
      why = "GL reports an error";
      break;
  }
  refuse(fmt::format("{} (GL_{})", why, gl::name_of<gl::ErrorCode>(error)));
}

void not_in_this_context(const Call& call) {
  const auto& context = call.stage.graphics.context();
  call.refuse(
      fmt::format("is not in this context, which has OpenGL {}.{}", context.major, context.minor));
}

}  // namespace shadowlab::lua
