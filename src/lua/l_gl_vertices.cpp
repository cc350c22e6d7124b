// Buffers, vertex arrays and draws: nothing is read past a buffer's end.
#include <fmt/format.h>

#include "lua/array.h"
#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

constexpr std::size_t most_buffer = std::size_t{256} << 20;
constexpr std::int64_t most_vertices = 50'000'000;  // of one draw, instances included

gl::VertexInput& vertices(const Call& call) { return call.stage.graphics.vertices; }

void binds_buffer(const Call& call) {
  vertices(call).bind_buffer(call.argument<gl::BufferTarget>(1),
                             call.argument<gl::BufferObject>(2));
}
void binds_array(const Call& call) {
  vertices(call).bind_array(call.argument<gl::VertexArrayObject>(1));
}

// OpenGL 4.5, table 23.55: at least 16 attributes.
GLuint attribute(const Call& call) {
  return static_cast<GLuint>(call.integer(1, 0, 15, "the number of an attribute, 0 to 15"));
}
void enables(const Call& call) { vertices(call).enable(attribute(call), true); }
void disables(const Call& call) { vertices(call).enable(attribute(call), false); }
void points(const Call& call) {
  vertices(call).point(attribute(call), call.argument<gl::Int>(2),
                       call.argument<gl::AttributeType>(3), call.argument<gl::Size>(5),
                       call.argument<gl::Offset>(6));
}

// The data comes as raw bytes or as floats; indices as integers: bound as elements, they are 32
// bits.
std::vector<std::byte> data(const Call& call, int index, GLenum target) {
  return read_bytes(call, index, target == GL_ARRAY_BUFFER ? GL_FLOAT : GL_UNSIGNED_INT,
                    most_buffer);
}

/// gl.BufferData(target, size, data, usage): size in bytes, data nil, a table or a string.
int buffer_data(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::BufferData};
  call.expect(4);
  const GLenum target = call.argument<gl::BufferTarget>(1);
  const auto size = static_cast<std::size_t>(
      call.integer(2, 0, most_buffer, "a number of bytes, at most 256 MiB"));
  const auto bytes = data(call, 3, target);
  const GLenum usage = call.argument<gl::BufferUsage>(4);
  if (!lua_isnil(L, 3) && bytes.size() != size) {
    call.refuse(fmt::format("size is {}, but the data has {} bytes", size, bytes.size()));
  }
  call.stage.graphics.objects.resize(gl::ObjectType::buffer, vertices(call).bound(target), size);
  vertices(call).set_data(target, size, bytes);
  call.gl().BufferData(target, static_cast<GLsizeiptr>(size), bytes, usage);
  call.check_error();
  return 0;
}

int buffer_sub_data(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::BufferSubData};
  call.expect(4);
  const GLenum target = call.argument<gl::BufferTarget>(1);
  const GLsizeiptr offset = call.argument<gl::ByteCount>(2), size = call.argument<gl::ByteCount>(3);
  const auto bytes = data(call, 4, target);
  if (bytes.size() != static_cast<std::size_t>(size)) {
    call.refuse(fmt::format("size is {}, but the data has {} bytes", size, bytes.size()));
  }
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

void draws_arrays(const Call& call) {
  const GLsizei count = call.argument<gl::Size>(3);
  may_draw(call, count, 1);
  vertices(call).check_arrays(call.argument<gl::Int>(2), count);
}
void draws_instances(const Call& call) {
  const GLsizei count = call.argument<gl::Size>(3);
  may_draw(call, count, call.argument<gl::Size>(4));
  vertices(call).check_arrays(call.argument<gl::Int>(2), count);
}
void draws_elements(const Call& call) {
  const GLsizei count = call.argument<gl::Size>(2);
  may_draw(call, count, 1);
  vertices(call).check_elements(count, call.argument<gl::IndexType>(3),
                                call.argument<gl::Offset>(4));
}

using bind::checked;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::BindBuffer, guarded<checked<&Functions::BindBuffer, binds_buffer>>, nullptr},
    {FunctionId::BindVertexArray, guarded<checked<&Functions::BindVertexArray, binds_array>>,
     nullptr},
    {FunctionId::EnableVertexAttribArray,
     guarded<checked<&Functions::EnableVertexAttribArray, enables>>, nullptr},
    {FunctionId::DisableVertexAttribArray,
     guarded<checked<&Functions::DisableVertexAttribArray, disables>>, nullptr},
    {FunctionId::VertexAttribPointer, guarded<checked<&Functions::VertexAttribPointer, points>>,
     nullptr},
    {FunctionId::BufferData, guarded<buffer_data>,
     "gl.BufferData(target, size, data: nil | {number, …} | bytes, usage)"},
    {FunctionId::BufferSubData, guarded<buffer_sub_data>,
     "gl.BufferSubData(target, offset, size, data: {number, …} | bytes)"},
    {FunctionId::DrawArrays, guarded<checked<&Functions::DrawArrays, draws_arrays>>, nullptr},
    {FunctionId::DrawArraysInstanced,
     guarded<checked<&Functions::DrawArraysInstanced, draws_instances>>, nullptr},
    {FunctionId::DrawElements, guarded<checked<&Functions::DrawElements, draws_elements>>, nullptr},
};

}  // namespace

std::span<const OwnFunction> gl_vertex_functions() { return functions; }

}  // namespace shadowlab::lua
