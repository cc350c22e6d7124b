// Framebuffers: what the main frame and framebuffer objects allow, clearing, accumulating.
#include <fmt/format.h>

#include <array>

#include "gl/sizes.h"
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
void check_color_buffer(const Call& call, GLenum name, GLuint framebuffer) {
  if (name == GL_NONE) return;
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
}

std::vector<GLenum> color_buffers(const Call& call, int count_index, GLuint framebuffer) {
  const int table = count_index + 1;
  const auto count = call.integer(count_index, 0, 8, "a number of buffers, 0 to 8");
  if (lua_type(call.L, table) != LUA_TTABLE) call.wrong_argument(table, "a table of buffers");
  if (static_cast<lua_Integer>(lua_rawlen(call.L, table)) != count) {
    call.refuse(fmt::format("n is {}, but the table has {}", count, lua_rawlen(call.L, table)));
  }
  std::vector<GLenum> buffers;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(call.L, table, i);
    const auto name = static_cast<GLenum>(lua_tointeger(call.L, -1));
    if (!lua_isinteger(call.L, -1) || !gl::is_one_of<gl::ColorBuffer>(name))
      call.wrong_element(table, i, gl::ColorBuffer::values);
    check_color_buffer(call, name, framebuffer);
    buffers.push_back(name);
    lua_pop(call.L, 1);
  }
  return buffers;
}

void draws_to(const Call& call, GLenum buffer) {
  check_color_buffer(call, buffer, bound_frame(call, GL_DRAW_FRAMEBUFFER));
}
void reads_from(const Call& call, GLenum buffer) {
  check_color_buffer(call, buffer, bound_frame(call, GL_READ_FRAMEBUFFER));
}
void names_buffer(const Call& call, GLuint framebuffer, GLenum buffer) {
  check_color_buffer(call, buffer, framebuffer);
}

int draw_buffers(lua_State* L) {
  const Call call = begin(L, FunctionId::DrawBuffers, 2);
  const auto buffers = color_buffers(call, 1, bound_frame(call, GL_DRAW_FRAMEBUFFER));
  call.gl().DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers);
  return done(call);
}

int named_draw_buffers(lua_State* L) {
  const Call call = begin(L, FunctionId::NamedFramebufferDrawBuffers, 3);
  if (!call.gl().NamedFramebufferDrawBuffers) not_in_this_context(call);
  const GLuint frame = call.argument<gl::FramebufferObject>(1);
  const auto buffers = color_buffers(call, 2, frame);
  call.gl().NamedFramebufferDrawBuffers(frame, static_cast<GLsizei>(buffers.size()), buffers);
  return done(call);
}

constexpr auto attaches = [](const Call& call, GLenum target, auto...) {
  refuse_main(call, bound_frame(call, target));
};
constexpr auto attaches_to_named = [](const Call& call, GLuint framebuffer, auto...) {
  refuse_main(call, framebuffer);
};

int clear(lua_State* L) {
  const Call call = begin(L, FunctionId::Clear, 1);
  const GLbitfield bits = call.argument<gl::ClearBits>(1);
  if (bits & GL_ACCUM_BUFFER_BIT) call.stage.graphics.accumulation.clear();
  call.gl().Clear(bits);
  return done(call);
}

int clear_accum(lua_State* L) {
  const Call call = begin(L, FunctionId::ClearAccum, 4);
  const auto [red, green, blue, alpha] =
      call.arguments<gl::Float, gl::Float, gl::Float, gl::Float>();
  call.stage.graphics.accumulation.set_clear_value({red, green, blue, alpha});
  call.gl().ClearAccum.record(red, green, blue, alpha);
  return 0;
}

int accum(lua_State* L) {
  const Call call = begin(L, FunctionId::Accum, 2);
  const auto [operation, value] = call.arguments<gl::AccumOperation, gl::Float>();
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
  const auto [buffer, index] = call.arguments<gl::ClearedBuffer, gl::Int>();
  (call.gl().*Member)(buffer, index, read_array_of<T>(call, 3, components(buffer)));
  return done(call);
}

int clear_named_framebuffer(lua_State* L) {
  const Call call = begin(L, FunctionId::ClearNamedFramebufferfv, 4);
  if (!call.gl().ClearNamedFramebufferfv) not_in_this_context(call);
  const auto [frame, buffer, index] =
      call.arguments<gl::FramebufferObject, gl::ClearedBuffer, gl::Int>();
  call.gl().ClearNamedFramebufferfv(frame, buffer, index,
                                    read_array_of<GLfloat>(call, 4, components(buffer)));
  return done(call);
}

// ---- renderbuffers: memory is counted before GL is asked for it

void count_bytes(const Call& call, GLuint renderbuffer, GLenum internal, GLsizei width,
                 GLsizei height, GLsizei samples) {
  constexpr GLsizei most_side = 16384, most_samples = 64;
  if (width > most_side || height > most_side)
    call.refuse(fmt::format("a renderbuffer is at most {} pixels wide and high", most_side));
  if (samples > most_samples) call.refuse(fmt::format("at most {} samples", most_samples));
  const std::uint64_t bytes = gl::texel_bytes(internal) * static_cast<std::uint64_t>(width) *
                              static_cast<std::uint64_t>(height) *
                              static_cast<std::uint64_t>(std::max(1, samples));
  call.stage.objects.resize(gl::ObjectType::renderbuffer, renderbuffer, bytes);
}

GLuint bound_renderbuffer(const Call& call) {
  GLint name = 0;
  call.gl().GetIntegerv.unrecorded(GL_RENDERBUFFER_BINDING, {&name, 1});
  if (name == 0) call.refuse("no renderbuffer is bound; call gl.BindRenderbuffer first");
  return static_cast<GLuint>(name);
}

void stores(const Call& call, GLenum, GLenum internal, GLsizei width, GLsizei height) {
  count_bytes(call, bound_renderbuffer(call), internal, width, height, 1);
}
void stores_samples(const Call& call, GLenum, GLsizei samples, GLenum internal, GLsizei width,
                    GLsizei height) {
  count_bytes(call, bound_renderbuffer(call), internal, width, height, samples);
}
void stores_named(const Call& call, GLuint renderbuffer, GLenum internal, GLsizei width,
                  GLsizei height) {
  count_bytes(call, renderbuffer, internal, width, height, 1);
}

using bind::plain;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::Clear, guarded<clear>, nullptr},
    {FunctionId::ClearAccum, guarded<clear_accum>, nullptr},
    {FunctionId::Accum, guarded<accum>, nullptr},
    {FunctionId::DrawBuffer, guarded<plain<&Functions::DrawBuffer, draws_to>>, nullptr},
    {FunctionId::DrawBuffers, guarded<draw_buffers>, "gl.DrawBuffers(n, {buffer, …})"},
    {FunctionId::ReadBuffer, guarded<plain<&Functions::ReadBuffer, reads_from>>, nullptr},
    {FunctionId::NamedFramebufferDrawBuffer,
     guarded<plain<&Functions::NamedFramebufferDrawBuffer, names_buffer>>, nullptr},
    {FunctionId::NamedFramebufferDrawBuffers, guarded<named_draw_buffers>,
     "gl.NamedFramebufferDrawBuffers(framebuffer, n, {buffer, …})"},
    {FunctionId::NamedFramebufferReadBuffer,
     guarded<plain<&Functions::NamedFramebufferReadBuffer, names_buffer>>, nullptr},
    {FunctionId::FramebufferTexture2D, guarded<plain<&Functions::FramebufferTexture2D, attaches>>,
     nullptr},
    {FunctionId::FramebufferTexture, guarded<plain<&Functions::FramebufferTexture, attaches>>,
     nullptr},
    {FunctionId::FramebufferTextureLayer,
     guarded<plain<&Functions::FramebufferTextureLayer, attaches>>, nullptr},
    {FunctionId::FramebufferRenderbuffer,
     guarded<plain<&Functions::FramebufferRenderbuffer, attaches>>, nullptr},
    {FunctionId::NamedFramebufferTexture,
     guarded<plain<&Functions::NamedFramebufferTexture, attaches_to_named>>, nullptr},
    {FunctionId::NamedFramebufferRenderbuffer,
     guarded<plain<&Functions::NamedFramebufferRenderbuffer, attaches_to_named>>, nullptr},
    {FunctionId::ClearBufferfv, guarded<clear_buffer<&Functions::ClearBufferfv, GLfloat>>,
     "gl.ClearBufferfv(buffer, drawbuffer, {number, …})"},
    {FunctionId::ClearBufferiv, guarded<clear_buffer<&Functions::ClearBufferiv, GLint>>,
     "gl.ClearBufferiv(buffer, drawbuffer, {integer, …})"},
    {FunctionId::ClearBufferuiv, guarded<clear_buffer<&Functions::ClearBufferuiv, GLuint>>,
     "gl.ClearBufferuiv(buffer, drawbuffer, {integer, …})"},
    {FunctionId::ClearNamedFramebufferfv, guarded<clear_named_framebuffer>,
     "gl.ClearNamedFramebufferfv(framebuffer, buffer, drawbuffer, {number, …})"},
    {FunctionId::RenderbufferStorage, guarded<plain<&Functions::RenderbufferStorage, stores>>,
     nullptr},
    {FunctionId::RenderbufferStorageMultisample,
     guarded<plain<&Functions::RenderbufferStorageMultisample, stores_samples>>, nullptr},
    {FunctionId::NamedRenderbufferStorage,
     guarded<plain<&Functions::NamedRenderbufferStorage, stores_named>>, nullptr},
};

}  // namespace

std::span<const OwnFunction> gl_frame_functions() { return functions; }

}  // namespace shadowlab::lua
