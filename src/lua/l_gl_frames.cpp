// Framebuffers: what the main frame and framebuffer objects allow, clearing, reading, accumulating.
#include <fmt/format.h>

#include <array>

#include "lua/array.h"
#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

Call begin(lua_State* L, FunctionId id, int arguments) {
  const Call call{L, stage_of_function(L), id};
  call.expect(arguments);
  return call;
}

int done(const Call& call) {
  call.check_error();
  return 0;
}

GLuint bound_frame(const Call& call, GLenum target) {
  GLint name = 0;
  call.gl().GetIntegerv.unrecorded(
      target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING,
      {&name, 1});
  return static_cast<GLuint>(name);
}

bool is_main(const Call& call, GLuint framebuffer) {
  return framebuffer == 0 || framebuffer == call.stage.graphics.calls().main_frame;
}

// The attachments of the main frame are not the recipe's to change: in GL it has none (OpenGL 4.5,
// section 9.2.8: INVALID_OPERATION).
void refuse_main(const Call& call, GLuint framebuffer) {
  if (is_main(call, framebuffer)) {
    call.refuse("the main frame takes no attachments; bind a framebuffer of your own first");
  }
}

// OpenGL 4.5, section 17.4.1: which names go with the main frame and which with an object.
GLenum color_buffer(const Call& call, int index, GLuint framebuffer) {
  const GLenum name = call.argument<gl::ColorBuffer>(index);
  if (name == GL_NONE) return name;
  const bool attachment = name >= GL_COLOR_ATTACHMENT0 && name <= GL_COLOR_ATTACHMENT7;
  if (is_main(call, framebuffer) && attachment) {
    call.refuse(
        "the main frame is bound, whose colour buffer is gl.BACK; gl.COLOR_ATTACHMENTi "
        "belong to framebuffer objects");
  }
  if (!is_main(call, framebuffer) && !attachment) {
    call.refuse(
        "a framebuffer object is bound, whose colour buffers are gl.COLOR_ATTACHMENT0 …; "
        "gl.BACK and its like belong to the main frame");
  }
  if (name == GL_RIGHT || name == GL_FRONT_RIGHT || name == GL_BACK_RIGHT) {
    call.refuse("the main frame is not stereo: it has no right buffer");
  }
  return name;
}

std::vector<GLenum> color_buffers(const Call& call, int count_index, int table_index,
                                  GLuint framebuffer) {
  const auto count = call.integer(count_index, 0, 8, "a number of buffers, 0 to 8");
  if (lua_type(call.L, table_index) != LUA_TTABLE)
    call.wrong_argument(table_index, "a table of buffers");
  if (static_cast<lua_Integer>(lua_rawlen(call.L, table_index)) != count) {
    call.refuse(
        fmt::format("n is {}, but the table has {}", count, lua_rawlen(call.L, table_index)));
  }
  std::vector<GLenum> buffers;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(call.L, table_index, i);
    lua_replace(call.L, table_index + 1);  // a place that `color_buffer` can name
    buffers.push_back(color_buffer(call, table_index + 1, framebuffer));
  }
  return buffers;
}

int draw_buffer(lua_State* L) {
  const Call call = begin(L, FunctionId::DrawBuffer, 1);
  call.gl().DrawBuffer(color_buffer(call, 1, bound_frame(call, GL_DRAW_FRAMEBUFFER)));
  return done(call);
}

int read_buffer(lua_State* L) {
  const Call call = begin(L, FunctionId::ReadBuffer, 1);
  call.gl().ReadBuffer(color_buffer(call, 1, bound_frame(call, GL_READ_FRAMEBUFFER)));
  return done(call);
}

int draw_buffers(lua_State* L) {
  const Call call = begin(L, FunctionId::DrawBuffers, 2);
  lua_settop(L, 3);
  const auto buffers = color_buffers(call, 1, 2, bound_frame(call, GL_DRAW_FRAMEBUFFER));
  call.gl().DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers);
  return done(call);
}

int named_draw_buffer(lua_State* L) {
  const Call call = begin(L, FunctionId::NamedFramebufferDrawBuffer, 2);
  if (!call.gl().NamedFramebufferDrawBuffer) not_in_this_context(call);
  const GLuint frame = call.argument<gl::FramebufferObject>(1);
  call.gl().NamedFramebufferDrawBuffer(frame, color_buffer(call, 2, frame));
  return done(call);
}

int named_draw_buffers(lua_State* L) {
  const Call call = begin(L, FunctionId::NamedFramebufferDrawBuffers, 3);
  if (!call.gl().NamedFramebufferDrawBuffers) not_in_this_context(call);
  lua_settop(L, 4);
  const GLuint frame = call.argument<gl::FramebufferObject>(1);
  const auto buffers = color_buffers(call, 2, 3, frame);
  call.gl().NamedFramebufferDrawBuffers(frame, static_cast<GLsizei>(buffers.size()), buffers);
  return done(call);
}

int named_read_buffer(lua_State* L) {
  const Call call = begin(L, FunctionId::NamedFramebufferReadBuffer, 2);
  if (!call.gl().NamedFramebufferReadBuffer) not_in_this_context(call);
  const GLuint frame = call.argument<gl::FramebufferObject>(1);
  call.gl().NamedFramebufferReadBuffer(frame, color_buffer(call, 2, frame));
  return done(call);
}

void attaches(const Call& call) {
  refuse_main(call, bound_frame(call, call.argument<gl::FramebufferTarget>(1)));
}

void attaches_to_named(const Call& call) {
  refuse_main(call, call.argument<gl::FramebufferObject>(1));
}

int clear(lua_State* L) {
  const Call call = begin(L, FunctionId::Clear, 1);
  const GLbitfield bits = call.argument<gl::ClearBits>(1);
  if (bits & GL_ACCUM_BUFFER_BIT) call.stage.graphics.accumulation.clear();
  call.gl().Clear(bits);
  return done(call);
}

int clear_accum(lua_State* L) {
  const Call call = begin(L, FunctionId::ClearAccum, 4);
  std::array<GLfloat, 4> value{};
  for (std::size_t i = 0; i < 4; ++i) value[i] = call.argument<gl::Float>(static_cast<int>(i) + 1);
  call.stage.graphics.accumulation.set_clear_value(value);
  call.gl().ClearAccum.record(value[0], value[1], value[2], value[3]);
  return 0;
}

int accum(lua_State* L) {
  const Call call = begin(L, FunctionId::Accum, 2);
  const GLenum operation = call.argument<gl::AccumOperation>(1);
  const GLfloat value = call.argument<gl::Float>(2);
  call.stage.graphics.accumulation.run(operation, value);
  call.gl().Accum.record(operation, value);
  return done(call);
}

// OpenGL 4.5, section 17.4.3.1: colour takes four numbers, depth and stencil one.
std::size_t components(GLenum buffer) { return buffer == GL_COLOR ? 4 : 1; }

template <auto Member, class T>
int clear_buffer(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call = begin(L, Function::id, 3);
  const GLenum buffer = call.argument<gl::ClearedBuffer>(1);
  const GLint index = call.argument<gl::Int>(2);
  (call.gl().*Member)(buffer, index, read_array_of<T>(call, 3, components(buffer)));
  return done(call);
}

int clear_named_framebuffer(lua_State* L) {
  const Call call = begin(L, FunctionId::ClearNamedFramebufferfv, 4);
  if (!call.gl().ClearNamedFramebufferfv) not_in_this_context(call);
  const GLuint frame = call.argument<gl::FramebufferObject>(1);
  const GLenum buffer = call.argument<gl::ClearedBuffer>(2);
  const GLint index = call.argument<gl::Int>(3);
  call.gl().ClearNamedFramebufferfv(frame, buffer, index,
                                    read_array_of<GLfloat>(call, 4, components(buffer)));
  return done(call);
}

// ---- renderbuffers: memory is counted before GL is asked for it

void count_bytes(const Call& call, GLuint renderbuffer, int width_index, GLsizei samples) {
  // 16 bytes a pixel is the most that a format of InternalFormat takes.
  const std::uint64_t bytes = std::uint64_t{16} *
                              static_cast<std::uint64_t>(call.argument<gl::Size>(width_index)) *
                              static_cast<std::uint64_t>(call.argument<gl::Size>(width_index + 1)) *
                              static_cast<std::uint64_t>(std::max(1, samples));
  call.stage.graphics.objects.resize(gl::ObjectType::renderbuffer, renderbuffer, bytes);
}

GLuint bound_renderbuffer(const Call& call) {
  GLint name = 0;
  call.gl().GetIntegerv.unrecorded(GL_RENDERBUFFER_BINDING, {&name, 1});
  if (name == 0) call.refuse("no renderbuffer is bound; call gl.BindRenderbuffer first");
  return static_cast<GLuint>(name);
}

void stores(const Call& call) { count_bytes(call, bound_renderbuffer(call), 3, 1); }
void stores_samples(const Call& call) {
  count_bytes(call, bound_renderbuffer(call), 4, std::min(call.argument<gl::Size>(2), 64));
}
void stores_named(const Call& call) {
  count_bytes(call, call.argument<gl::RenderbufferObject>(1), 3, 1);
}

int get_attachment_parameter(lua_State* L) {
  const Call call = begin(L, FunctionId::GetFramebufferAttachmentParameteriv, 3);
  GLint value = 0;
  call.gl().GetFramebufferAttachmentParameteriv(
      call.argument<gl::FramebufferTarget>(1), call.argument<gl::Attachment>(2),
      call.argument<gl::AttachmentParameter>(3), {&value, 1});
  call.check_error();
  return push_result<gl::Int>(L, value);
}

int get_renderbuffer_parameter(lua_State* L) {
  const Call call = begin(L, FunctionId::GetRenderbufferParameteriv, 2);
  GLint value = 0;
  call.gl().GetRenderbufferParameteriv(call.argument<gl::RenderbufferTarget>(1),
                                       call.argument<gl::RenderbufferParameter>(2), {&value, 1});
  call.check_error();
  return push_result<gl::Int>(L, value);
}

// ---- reading back

std::size_t components_of(const Call& call, GLenum format) {
  switch (format) {
    case GL_RG:
    case GL_RG_INTEGER:
      return 2;
    case GL_RGB:
    case GL_BGR:
    case GL_RGB_INTEGER:
      return 3;
    case GL_RGBA:
    case GL_BGRA:
    case GL_RGBA_INTEGER:
      return 4;
    case GL_DEPTH_STENCIL:
      call.refuse("read gl.DEPTH_COMPONENT and gl.STENCIL_INDEX one by one");
    default:
      return 1;
  }
}

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
  const Call call = begin(L, FunctionId::ReadPixels, 6);
  const GLint x = call.argument<gl::Int>(1), y = call.argument<gl::Int>(2);
  const GLsizei width = call.argument<gl::Size>(3), height = call.argument<gl::Size>(4);
  const GLenum format = call.argument<gl::PixelFormat>(5), type = call.argument<gl::PixelType>(6);
  if (type == GL_UNSIGNED_INT_24_8)
    call.refuse("read gl.DEPTH_COMPONENT and gl.STENCIL_INDEX one by one");
  const std::size_t numbers = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              components_of(call, format);
  if (numbers > (std::size_t{1} << 24)) call.refuse("reads at most 16 million numbers at once");
  call.stage.state.check_budget(numbers);
  const std::size_t each = bytes_of_type(type);
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

using bind::checked;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::Clear, guarded<clear>, nullptr},
    {FunctionId::ClearAccum, guarded<clear_accum>, nullptr},
    {FunctionId::Accum, guarded<accum>, nullptr},
    {FunctionId::DrawBuffer, guarded<draw_buffer>, nullptr},
    {FunctionId::DrawBuffers, guarded<draw_buffers>, "gl.DrawBuffers(n, {buffer, …})"},
    {FunctionId::ReadBuffer, guarded<read_buffer>, nullptr},
    {FunctionId::NamedFramebufferDrawBuffer, guarded<named_draw_buffer>, nullptr},
    {FunctionId::NamedFramebufferDrawBuffers, guarded<named_draw_buffers>,
     "gl.NamedFramebufferDrawBuffers(framebuffer, n, {buffer, …})"},
    {FunctionId::NamedFramebufferReadBuffer, guarded<named_read_buffer>, nullptr},
    {FunctionId::FramebufferTexture2D, guarded<checked<&Functions::FramebufferTexture2D, attaches>>,
     nullptr},
    {FunctionId::FramebufferTexture, guarded<checked<&Functions::FramebufferTexture, attaches>>,
     nullptr},
    {FunctionId::FramebufferTextureLayer,
     guarded<checked<&Functions::FramebufferTextureLayer, attaches>>, nullptr},
    {FunctionId::FramebufferRenderbuffer,
     guarded<checked<&Functions::FramebufferRenderbuffer, attaches>>, nullptr},
    {FunctionId::NamedFramebufferTexture,
     guarded<checked<&Functions::NamedFramebufferTexture, attaches_to_named>>, nullptr},
    {FunctionId::NamedFramebufferRenderbuffer,
     guarded<checked<&Functions::NamedFramebufferRenderbuffer, attaches_to_named>>, nullptr},
    {FunctionId::ClearBufferfv, guarded<clear_buffer<&Functions::ClearBufferfv, GLfloat>>,
     "gl.ClearBufferfv(buffer, drawbuffer, {number, …})"},
    {FunctionId::ClearBufferiv, guarded<clear_buffer<&Functions::ClearBufferiv, GLint>>,
     "gl.ClearBufferiv(buffer, drawbuffer, {integer, …})"},
    {FunctionId::ClearBufferuiv, guarded<clear_buffer<&Functions::ClearBufferuiv, GLuint>>,
     "gl.ClearBufferuiv(buffer, drawbuffer, {integer, …})"},
    {FunctionId::ClearNamedFramebufferfv, guarded<clear_named_framebuffer>,
     "gl.ClearNamedFramebufferfv(framebuffer, buffer, drawbuffer, {number, …})"},
    {FunctionId::RenderbufferStorage, guarded<checked<&Functions::RenderbufferStorage, stores>>,
     nullptr},
    {FunctionId::RenderbufferStorageMultisample,
     guarded<checked<&Functions::RenderbufferStorageMultisample, stores_samples>>, nullptr},
    {FunctionId::NamedRenderbufferStorage,
     guarded<checked<&Functions::NamedRenderbufferStorage, stores_named>>, nullptr},
    {FunctionId::GetFramebufferAttachmentParameteriv, guarded<get_attachment_parameter>,
     "gl.GetFramebufferAttachmentParameteriv(target, attachment, pname) -> integer"},
    {FunctionId::GetRenderbufferParameteriv, guarded<get_renderbuffer_parameter>,
     "gl.GetRenderbufferParameteriv(target, pname) -> integer"},
    {FunctionId::ReadPixels, guarded<read_pixels>,
     "gl.ReadPixels(x, y, width, height, format, type) -> {number, …}"},
};

}  // namespace

std::span<const OwnFunction> gl_frame_functions() { return functions; }

}  // namespace shadowlab::lua
