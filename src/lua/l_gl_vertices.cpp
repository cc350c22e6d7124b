// Buffers, vertex arrays and draws: nothing is read past a buffer's end.
#include <fmt/format.h>

#include "lua/array.h"
#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

constexpr lua_Integer most_buffer = lua_Integer{256} << 20;
constexpr std::int64_t most_vertices = 50'000'000;  // of one draw, instances included

gl::VertexInput& vertices(const Call& call) { return call.stage.graphics.vertices; }

void binds_buffer(const Call& call, GLenum target, GLuint buffer) {
  vertices(call).bind_buffer(target, buffer);
}
void binds_array(const Call& call, GLuint array) { vertices(call).bind_array(array); }

void check_attribute(const Call& call, GLuint index) {
  if (index >= gl::VertexInput::attributes)
    call.wrong_argument(
        1, fmt::format("the number of an attribute, 0 to {}", gl::VertexInput::attributes - 1));
}
void enables(const Call& call, GLuint index) {
  check_attribute(call, index);
  vertices(call).enable(index, true);
}
void disables(const Call& call, GLuint index) {
  check_attribute(call, index);
  vertices(call).enable(index, false);
}
void may_point(const Call& call, GLuint index, GLint size, GLenum, GLboolean, GLsizei stride,
               GLsizeiptr) {
  check_attribute(call, index);
  vertices(call).check_pointer(size, stride);
}
// What is remembered follows what GL has accepted, never what it refused.
void points(const Call& call, GLuint index, GLint size, GLenum type, GLboolean, GLsizei stride,
            GLsizeiptr offset) {
  vertices(call).point(index, size, type, stride, offset);
}

// The data comes as raw bytes or as floats; indices as integers: bound as elements, they are 32
// bits.
std::vector<std::byte> data(const Call& call, int index, GLenum target) {
  return read_bytes(call, index, target == GL_ARRAY_BUFFER ? GL_FLOAT : GL_UNSIGNED_INT,
                    static_cast<std::size_t>(most_buffer));
}

GLuint bound_buffer(const Call& call, GLenum target) {
  const GLuint buffer = vertices(call).bound(target);
  if (buffer == 0) call.refuse("no buffer is bound to this target; call gl.BindBuffer first");
  return buffer;
}

void check_size(const Call& call, GLsizeiptr size, std::span<const std::byte> bytes) {
  if (bytes.size() != static_cast<std::size_t>(size)) {
    call.refuse(fmt::format("size is {}, but the data has {} bytes", size, bytes.size()));
  }
}

/// gl.BufferData(target, size, data, usage): size in bytes, data nil, a table or a string.
int buffer_data(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::BufferData};
  call.expect(4);
  const GLenum target = call.argument<gl::BufferTarget>(1);
  const GLsizeiptr size = call.integer(2, 0, most_buffer, "a number of bytes, at most 256 MiB");
  const auto bytes = data(call, 3, target);
  const GLenum usage = call.argument<gl::BufferUsage>(4);
  if (!lua_isnil(L, 3)) check_size(call, size, bytes);
  call.stage.objects.resize(gl::ObjectType::buffer, bound_buffer(call, target),
                            static_cast<std::uint64_t>(size));
  call.gl().BufferData(target, size, bytes, usage);
  call.check_error();
  vertices(call).set_data(target, static_cast<std::size_t>(size), bytes);
  return 0;
}

int buffer_sub_data(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::BufferSubData};
  call.expect(4);
  const auto [target, offset, size] =
      call.arguments<gl::BufferTarget, gl::ByteCount, gl::ByteCount>();
  const auto bytes = data(call, 4, target);
  check_size(call, size, bytes);
  bound_buffer(call, target);
  vertices(call).set_part(target, static_cast<std::size_t>(offset), bytes);
  call.gl().BufferSubData(target, offset, size, bytes);
  call.check_error();
  return 0;
}

void may_draw(const Call& call, std::int64_t count, std::int64_t instances) {
  GLint program = 0;
  call.gl().GetIntegerv.unrecorded(GL_CURRENT_PROGRAM, {&program, 1});
  if (program == 0) call.refuse("no program is in use; call gl.UseProgram or shader:use first");
  if (count * instances > most_vertices) {
    call.refuse(fmt::format("draws at most {} million vertices", most_vertices / 1'000'000));
  }
  call.stage.state.check_budget(static_cast<std::uint64_t>(count * instances));
}

void draws_arrays(const Call& call, GLenum, GLint first, GLsizei count) {
  may_draw(call, count, 1);
  vertices(call).check_arrays(first, count);
}
void draws_instances(const Call& call, GLenum, GLint first, GLsizei count, GLsizei instances) {
  may_draw(call, count, instances);
  vertices(call).check_arrays(first, count);
}
void draws_elements(const Call& call, GLenum, GLsizei count, GLenum type, GLsizeiptr offset) {
  may_draw(call, count, 1);
  std::optional<GLuint> restart;
  if (call.gl().IsEnabled.unrecorded(GL_PRIMITIVE_RESTART)) {
    GLint index = 0;
    call.gl().GetIntegerv.unrecorded(GL_PRIMITIVE_RESTART_INDEX, {&index, 1});
    restart = static_cast<GLuint>(index);
  }
  vertices(call).check_elements(count, type, offset, restart);
}

using bind::plain;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::BindBuffer, guarded<plain<&Functions::BindBuffer, binds_buffer>>, nullptr},
    {FunctionId::BindVertexArray, guarded<plain<&Functions::BindVertexArray, binds_array>>,
     nullptr},
    {FunctionId::EnableVertexAttribArray,
     guarded<plain<&Functions::EnableVertexAttribArray, enables>>, nullptr},
    {FunctionId::DisableVertexAttribArray,
     guarded<plain<&Functions::DisableVertexAttribArray, disables>>, nullptr},
    {FunctionId::VertexAttribPointer,
     guarded<plain<&Functions::VertexAttribPointer, may_point, points>>, nullptr},
    {FunctionId::BufferData, guarded<buffer_data>,
     "gl.BufferData(target, size, data: nil | {number, …} | bytes, usage)"},
    {FunctionId::BufferSubData, guarded<buffer_sub_data>,
     "gl.BufferSubData(target, offset, size, data: {number, …} | bytes)"},
    {FunctionId::DrawArrays, guarded<plain<&Functions::DrawArrays, draws_arrays>>, nullptr},
    {FunctionId::DrawArraysInstanced,
     guarded<plain<&Functions::DrawArraysInstanced, draws_instances>>, nullptr},
    {FunctionId::DrawElements, guarded<plain<&Functions::DrawElements, draws_elements>>, nullptr},
};

}  // namespace

std::span<const OwnFunction> gl_vertex_functions() { return functions; }

}  // namespace shadowlab::lua
