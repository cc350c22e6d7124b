// What GL is asked: state, counts of drawn samples, pixels.
#include <array>
#include <cstring>

#include "gl/sizes.h"
#include "lua/array.h"
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

bool main_frame_is_bound(const Call& call, GLenum buffer_name) {
  GLint bound = 0;
  call.gl().GetIntegerv.unrecorded(
      buffer_name == GL_DRAW_BUFFER ? GL_DRAW_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING,
      {&bound, 1});
  return static_cast<GLuint>(bound) == call.stage.graphics.calls().main_frame;
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
    // The main frame's colour buffer is an attachment to GL alone.
    if ((name == GL_DRAW_BUFFER || name == GL_READ_BUFFER) && main_frame_is_bound(call, name) &&
        values[0] != static_cast<T>(GL_NONE)) {
      values[0] = static_cast<T>(GL_BACK);
    }
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
  const auto [query, parameter] = call.arguments<gl::QueryObject, gl::QueryParameter>();
  GLuint value = 0;
  call.gl().GetQueryObjectuiv(query, parameter, {&value, 1});
  call.check_error();
  lua_pushinteger(L, value);
  return 1;
}

int get_attachment_parameter(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::GetFramebufferAttachmentParameteriv};
  call.expect(3);
  const auto [target, attachment, parameter] =
      call.arguments<gl::FramebufferTarget, gl::Attachment, gl::AttachmentParameter>();
  GLint value = 0;
  call.gl().GetFramebufferAttachmentParameteriv(target, attachment, parameter, {&value, 1});
  call.check_error();
  return push_result<gl::Int>(L, value);
}

int get_renderbuffer_parameter(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::GetRenderbufferParameteriv};
  call.expect(2);
  const auto [target, parameter] =
      call.arguments<gl::RenderbufferTarget, gl::RenderbufferParameter>();
  GLint value = 0;
  call.gl().GetRenderbufferParameteriv(target, parameter, {&value, 1});
  call.check_error();
  return push_result<gl::Int>(L, value);
}

// ---- reading back

double number_at(const std::byte* bytes, GLenum type) {
  const auto as = [bytes]<class T>(T value) {
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case GL_BYTE:
      return as(GLbyte{});
    case GL_UNSIGNED_BYTE:
      return as(GLubyte{});
    case GL_SHORT:
      return as(GLshort{});
    case GL_UNSIGNED_SHORT:
      return as(GLushort{});
    case GL_INT:
      return as(GLint{});
    case GL_FLOAT:
      return as(GLfloat{});
    default:
      return as(GLuint{});
  }
}

/// A table of numbers, row by row from the lowest, as GL fills its array.
int read_pixels(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::ReadPixels};
  call.expect(6);
  const auto [x, y, width, height, format, type] =
      call.arguments<gl::Int, gl::Int, gl::Size, gl::Size, gl::PixelFormat, gl::PixelType>();
  if (format == GL_DEPTH_STENCIL || type == GL_UNSIGNED_INT_24_8)
    call.refuse("read gl.DEPTH_COMPONENT and gl.STENCIL_INDEX one by one");
  const std::size_t numbers = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              gl::components_of(format);
  if (numbers > (std::size_t{1} << 24)) call.refuse("reads at most 16 million numbers at once");
  call.stage.state.check_budget(numbers);
  const std::size_t each = gl::bytes_of_type(type);
  std::vector<std::byte> pixels(numbers * each);
  GLint alignment = 4;
  call.gl().GetIntegerv.unrecorded(GL_PACK_ALIGNMENT, {&alignment, 1});
  call.gl().PixelStorei.unrecorded(GL_PACK_ALIGNMENT, 1);
  call.gl().ReadPixels(x, y, width, height, format, type, pixels);
  call.gl().PixelStorei.unrecorded(GL_PACK_ALIGNMENT, alignment);
  call.check_error();
  lua_createtable(L, static_cast<int>(numbers), 0);
  for (std::size_t i = 0; i < numbers; ++i) {
    const double number = number_at(pixels.data() + i * each, type);
    if (type == GL_FLOAT) {
      lua_pushnumber(L, number);
    } else {
      lua_pushinteger(L, static_cast<lua_Integer>(number));
    }
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
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
    {FunctionId::GetFramebufferAttachmentParameteriv, guarded<get_attachment_parameter>,
     "gl.GetFramebufferAttachmentParameteriv(target, attachment, pname) -> integer"},
    {FunctionId::GetRenderbufferParameteriv, guarded<get_renderbuffer_parameter>,
     "gl.GetRenderbufferParameteriv(target, pname) -> integer"},
    {FunctionId::ReadPixels, guarded<read_pixels>,
     "gl.ReadPixels(x, y, width, height, format, type) -> {number, …}"},
};

}  // namespace

std::span<const OwnFunction> gl_query_functions() { return functions; }

}  // namespace shadowlab::lua
