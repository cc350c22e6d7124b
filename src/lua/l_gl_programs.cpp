// Shaders and programs by GL's own names, for those who do not use shader.load.
#include <array>

#include "lua/array.h"
#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

constexpr std::size_t most_source = std::size_t{1} << 20;

int create_shader(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::CreateShader};
  call.expect(1);
  const GLuint name = call.gl().CreateShader(call.argument<gl::ShaderStage>(1));
  call.check_error();
  push_object(call.stage, L, gl::ObjectType::shader, name);
  return 1;
}

int create_program(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::CreateProgram};
  call.expect(0);
  const GLuint name = call.gl().CreateProgram();
  call.check_error();
  push_object(call.stage, L, gl::ObjectType::program, name);
  return 1;
}

template <auto Member, class Kind>
int remove(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(1);
  const auto object = object_at(call, 1, gl::object_type<Kind>);
  const auto name = object ? call.stage.objects.find(*object) : std::nullopt;
  if (!name) return 0;
  if constexpr (std::is_same_v<Kind, gl::ProgramObject>) {
    // In use, it lives on until another is used (OpenGL 4.5, section 7.3); to the core's own
    // drawing, which comes between, it must still be there.
    (call.gl().*Member).record(*name);
    call.stage.graphics.delete_when_unused(*name);
  } else {
    (call.gl().*Member)(*name);
  }
  call.stage.objects.remove(*object);
  call.check_error();
  return 0;
}

/// gl.ShaderSource(shader, text): the count and the lengths of C are the string's own.
int shader_source(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::ShaderSource};
  call.expect(2);
  const GLuint shader = call.argument<gl::ShaderObject>(1);
  if (lua_type(L, 2) != LUA_TSTRING) call.wrong_argument(2, "the text of the shader");
  std::size_t size = 0;
  const char* text = lua_tolstring(L, 2, &size);
  if (size > most_source) call.refuse("a shader's text is at most 1 MiB");
  const auto length = static_cast<GLint>(size);
  call.gl().ShaderSource(shader, 1, {&text, 1}, {&length, 1});
  call.check_error();
  return 0;
}

template <auto Member, class Kind, class Parameter>
int get(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(2);
  GLint value = 0;
  const auto [name, parameter] = call.arguments<Kind, Parameter>();
  (call.gl().*Member)(name, parameter, {&value, 1});
  call.check_error();
  return push_result<gl::Int>(L, value);
}

template <auto Member, class Kind>
int log(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(1);
  std::array<GLchar, 8192> text{};
  GLsizei length = 0;
  (call.gl().*Member)(call.argument<Kind>(1), static_cast<GLsizei>(text.size()), {&length, 1},
                      text);
  call.check_error();
  lua_pushlstring(L, text.data(), static_cast<std::size_t>(length));
  return 1;
}

/// gl.Uniform3fv(location, count, {…}): count × Components numbers.
template <auto Member, class T, int Components>
int uniform(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(3);
  const GLint location = call.argument<gl::Int>(1);
  const auto count = static_cast<GLsizei>(call.integer(2, 0, 4096, "a count, 0 to 4096"));
  call.stage.graphics.calls().foreign_uniforms++;
  (call.gl().*Member)(location, count,
                      read_array_of<T>(call, 3, static_cast<std::size_t>(count) * Components));
  call.check_error();
  return 0;
}

template <auto Member, int Components>
int matrix(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(4);
  const GLint location = call.argument<gl::Int>(1);
  const auto count = static_cast<GLsizei>(call.integer(2, 0, 1024, "a count, 0 to 1024"));
  const GLboolean transpose = call.argument<gl::Bool>(3);
  call.stage.graphics.calls().foreign_uniforms++;
  (call.gl().*Member)(
      location, count, transpose,
      read_array_of<GLfloat>(call, 4, static_cast<std::size_t>(count) * Components));
  call.check_error();
  return 0;
}

using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::CreateShader, guarded<create_shader>, "gl.CreateShader(type) -> shader"},
    {FunctionId::CreateProgram, guarded<create_program>, "gl.CreateProgram() -> program"},
    {FunctionId::DeleteShader, guarded<remove<&Functions::DeleteShader, gl::ShaderObject>>,
     nullptr},
    {FunctionId::DeleteProgram, guarded<remove<&Functions::DeleteProgram, gl::ProgramObject>>,
     nullptr},
    {FunctionId::ShaderSource, guarded<shader_source>, "gl.ShaderSource(shader, text)"},
    {FunctionId::GetShaderiv,
     guarded<get<&Functions::GetShaderiv, gl::ShaderObject, gl::ShaderParameter>>,
     "gl.GetShaderiv(shader, pname) -> integer"},
    {FunctionId::GetProgramiv,
     guarded<get<&Functions::GetProgramiv, gl::ProgramObject, gl::ProgramParameter>>,
     "gl.GetProgramiv(program, pname) -> integer"},
    {FunctionId::GetShaderInfoLog, guarded<log<&Functions::GetShaderInfoLog, gl::ShaderObject>>,
     "gl.GetShaderInfoLog(shader) -> text"},
    {FunctionId::GetProgramInfoLog, guarded<log<&Functions::GetProgramInfoLog, gl::ProgramObject>>,
     "gl.GetProgramInfoLog(program) -> text"},
    {FunctionId::Uniform1fv, guarded<uniform<&Functions::Uniform1fv, GLfloat, 1>>,
     "gl.Uniform1fv(location, count, {number, …})"},
    {FunctionId::Uniform2fv, guarded<uniform<&Functions::Uniform2fv, GLfloat, 2>>,
     "gl.Uniform2fv(location, count, {number, …})"},
    {FunctionId::Uniform3fv, guarded<uniform<&Functions::Uniform3fv, GLfloat, 3>>,
     "gl.Uniform3fv(location, count, {number, …})"},
    {FunctionId::Uniform4fv, guarded<uniform<&Functions::Uniform4fv, GLfloat, 4>>,
     "gl.Uniform4fv(location, count, {number, …})"},
    {FunctionId::Uniform1iv, guarded<uniform<&Functions::Uniform1iv, GLint, 1>>,
     "gl.Uniform1iv(location, count, {integer, …})"},
    {FunctionId::Uniform2iv, guarded<uniform<&Functions::Uniform2iv, GLint, 2>>,
     "gl.Uniform2iv(location, count, {integer, …})"},
    {FunctionId::Uniform3iv, guarded<uniform<&Functions::Uniform3iv, GLint, 3>>,
     "gl.Uniform3iv(location, count, {integer, …})"},
    {FunctionId::Uniform4iv, guarded<uniform<&Functions::Uniform4iv, GLint, 4>>,
     "gl.Uniform4iv(location, count, {integer, …})"},
    {FunctionId::Uniform1uiv, guarded<uniform<&Functions::Uniform1uiv, GLuint, 1>>,
     "gl.Uniform1uiv(location, count, {integer, …})"},
    {FunctionId::Uniform2uiv, guarded<uniform<&Functions::Uniform2uiv, GLuint, 2>>,
     "gl.Uniform2uiv(location, count, {integer, …})"},
    {FunctionId::Uniform3uiv, guarded<uniform<&Functions::Uniform3uiv, GLuint, 3>>,
     "gl.Uniform3uiv(location, count, {integer, …})"},
    {FunctionId::Uniform4uiv, guarded<uniform<&Functions::Uniform4uiv, GLuint, 4>>,
     "gl.Uniform4uiv(location, count, {integer, …})"},
    {FunctionId::UniformMatrix2fv, guarded<matrix<&Functions::UniformMatrix2fv, 4>>,
     "gl.UniformMatrix2fv(location, count, transpose, {number, …})"},
    {FunctionId::UniformMatrix3fv, guarded<matrix<&Functions::UniformMatrix3fv, 9>>,
     "gl.UniformMatrix3fv(location, count, transpose, mat3 | {number, …})"},
    {FunctionId::UniformMatrix4fv, guarded<matrix<&Functions::UniformMatrix4fv, 16>>,
     "gl.UniformMatrix4fv(location, count, transpose, mat4 | {number, …})"},
};

}  // namespace

std::span<const OwnFunction> gl_program_functions() { return functions; }

}  // namespace shadowlab::lua
