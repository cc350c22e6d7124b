// What GL is asked: state, and counts of drawn samples.
#include <array>

#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

// The main frame is ours, so its bits are ours to tell: a framebuffer object has none to a driver
// (OpenGL 4.5, section 9.2.3), and no accumulation buffer.
std::optional<GLint> own_state(const Call& call, GLenum name) {
  switch (name) {
    case GL_RED_BITS:
    case GL_GREEN_BITS:
    case GL_BLUE_BITS:
    case GL_ALPHA_BITS:
    case GL_STENCIL_BITS:
      return 8;
    case GL_DEPTH_BITS:
      return 24;
    case GL_ACCUM_RED_BITS:
    case GL_ACCUM_GREEN_BITS:
    case GL_ACCUM_BLUE_BITS:
    case GL_ACCUM_ALPHA_BITS:
      return gl::bits_of(call.stage.graphics.accumulation.storage());
    default:
      return {};
  }
}

// Names of objects are no integers in Lua.
bool is_object(GLenum name) {
  return name == GL_ARRAY_BUFFER_BINDING || name == GL_CURRENT_PROGRAM;
}

template <auto Member, class T>
int get(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(1);
  const GLenum name = call.argument<gl::StateName>(1);
  if (is_object(name))
    call.refuse("names of objects are not integers here; keep the object you bound");
  std::array<T, 16> values{};
  const int count = gl::state_size(name);
  if (const auto own = own_state(call, name)) {
    values[0] = static_cast<T>(*own);
  } else {
    (call.gl().*Member)(name, values);
    call.check_error();
  }
  for (int i = 0; i < count; ++i) {
    const T value = values[static_cast<std::size_t>(i)];
    if constexpr (std::is_same_v<T, GLfloat>) {
      lua_pushnumber(L, value);
    } else if constexpr (std::is_same_v<T, GLboolean>) {
      lua_pushboolean(L, value);
    } else {
      lua_pushinteger(L, value);
    }
  }
  return count;
}

int get_query(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::GetQueryObjectuiv};
  call.expect(2);
  GLuint value = 0;
  const GLuint query = call.argument<gl::QueryObject>(1);
  call.gl().GetQueryObjectuiv(query, call.argument<gl::QueryParameter>(2), {&value, 1});
  call.check_error();
  lua_pushinteger(L, value);
  return 1;
}

using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::GetIntegerv, guarded<get<&Functions::GetIntegerv, GLint>>,
     "gl.GetIntegerv(pname) -> integer…"},
    {FunctionId::GetFloatv, guarded<get<&Functions::GetFloatv, GLfloat>>,
     "gl.GetFloatv(pname) -> number…"},
    {FunctionId::GetBooleanv, guarded<get<&Functions::GetBooleanv, GLboolean>>,
     "gl.GetBooleanv(pname) -> boolean…"},
    {FunctionId::GetQueryObjectuiv, guarded<get_query>,
     "gl.GetQueryObjectuiv(id, pname) -> integer"},
};

}  // namespace

std::span<const OwnFunction> gl_query_functions() { return functions; }

}  // namespace shadowlab::lua
