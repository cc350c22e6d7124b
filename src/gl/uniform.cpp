// The types of uniforms: how many words each takes, and which function of GL sends it.
#include <span>

#include "gl/program.h"

namespace shadowlab::gl {
namespace {

struct TypeShape {
  GLenum type;
  std::size_t components;
  bool floating;
};

TypeShape shape_of(GLenum type) {
  static constexpr TypeShape shapes[] = {{GL_FLOAT, 1, true},
                                         {GL_FLOAT_VEC2, 2, true},
                                         {GL_FLOAT_VEC3, 3, true},
                                         {GL_FLOAT_VEC4, 4, true},
                                         {GL_FLOAT_MAT2, 4, true},
                                         {GL_FLOAT_MAT3, 9, true},
                                         {GL_FLOAT_MAT4, 16, true},
                                         {GL_INT, 1, false},
                                         {GL_INT_VEC2, 2, false},
                                         {GL_INT_VEC3, 3, false},
                                         {GL_INT_VEC4, 4, false},
                                         {GL_BOOL, 1, false},
                                         {GL_BOOL_VEC2, 2, false},
                                         {GL_BOOL_VEC3, 3, false},
                                         {GL_BOOL_VEC4, 4, false},
                                         {GL_UNSIGNED_INT, 1, false},
                                         {GL_UNSIGNED_INT_VEC2, 2, false},
                                         {GL_UNSIGNED_INT_VEC3, 3, false},
                                         {GL_UNSIGNED_INT_VEC4, 4, false}};
  for (const TypeShape& shape : shapes) {
    if (shape.type == type) return shape;
  }
  return {type, 1, false};  // samplers: the number of a texture unit
}

}  // namespace

std::size_t Uniform::words() const {
  return shape_of(type).components * static_cast<std::size_t>(count);
}

bool Uniform::floating() const { return shape_of(type).floating; }

// Doubles and matrices that are not square (OpenGL 4.5, table 7.3).
bool Uniform::supported() const {
  return !(type == GL_DOUBLE || (type >= GL_FLOAT_MAT2x3 && type <= GL_FLOAT_MAT4x3) ||
           (type >= GL_DOUBLE_MAT2 && type <= GL_DOUBLE_MAT4x3) ||
           (type >= GL_DOUBLE_VEC2 && type <= GL_DOUBLE_VEC4));
}

void Uniform::send(const Functions& gl, const std::uint32_t* values) const {
  const std::size_t n = words();
  const std::span floats(reinterpret_cast<const GLfloat*>(values), n);
  const std::span ints(reinterpret_cast<const GLint*>(values), n);
  const std::span<const GLuint> unsigned_ints(values, n);
  switch (type) {
    case GL_FLOAT:
      count == 1 ? gl.Uniform1f(location, floats[0]) : gl.Uniform1fv(location, count, floats);
      break;
    case GL_FLOAT_VEC2:
      gl.Uniform2fv(location, count, floats);
      break;
    case GL_FLOAT_VEC3:
      gl.Uniform3fv(location, count, floats);
      break;
    case GL_FLOAT_VEC4:
      gl.Uniform4fv(location, count, floats);
      break;
    case GL_FLOAT_MAT2:
      gl.UniformMatrix2fv(location, count, GL_FALSE, floats);
      break;
    case GL_FLOAT_MAT3:
      gl.UniformMatrix3fv(location, count, GL_FALSE, floats);
      break;
    case GL_FLOAT_MAT4:
      gl.UniformMatrix4fv(location, count, GL_FALSE, floats);
      break;
    case GL_INT_VEC2:
    case GL_BOOL_VEC2:
      gl.Uniform2iv(location, count, ints);
      break;
    case GL_INT_VEC3:
    case GL_BOOL_VEC3:
      gl.Uniform3iv(location, count, ints);
      break;
    case GL_INT_VEC4:
    case GL_BOOL_VEC4:
      gl.Uniform4iv(location, count, ints);
      break;
    case GL_UNSIGNED_INT:
      gl.Uniform1uiv(location, count, unsigned_ints);
      break;
    case GL_UNSIGNED_INT_VEC2:
      gl.Uniform2uiv(location, count, unsigned_ints);
      break;
    case GL_UNSIGNED_INT_VEC3:
      gl.Uniform3uiv(location, count, unsigned_ints);
      break;
    case GL_UNSIGNED_INT_VEC4:
      gl.Uniform4uiv(location, count, unsigned_ints);
      break;
    default:
      count == 1 ? gl.Uniform1i(location, ints[0]) : gl.Uniform1iv(location, count, ints);
      break;
  }
  if (gl.Uniform1i.shared->recorder) gl.Uniform1i.shared->recorder->comment(name);
}

}  // namespace shadowlab::gl
