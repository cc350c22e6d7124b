// What a draw call would read: checked before GL does, since GL itself need not.
//
// A recipe that calls gl.VertexAttribPointer and gl.DrawElements by itself can point past the end
// of a buffer; OpenGL 4.5, section 6.4, leaves what happens then to the driver. So the sizes of
// buffers, the contents of index buffers and the attributes of vertex arrays are remembered here.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gl/functions.h"

namespace shadowlab::gl {

class VertexInput {
 public:
  /// OpenGL 4.5, table 23.55: as many as every context has.
  static constexpr GLuint attributes = 16;

  void bind_buffer(GLenum target, GLuint buffer);
  /// glBufferData and glBufferSubData on the buffer bound to `target`. Throw InputError where none
  /// is bound or the range does not fit.
  void set_data(GLenum target, std::size_t size, std::span<const std::byte> data);
  void set_part(GLenum target, std::size_t offset, std::span<const std::byte> data);
  GLuint bound(GLenum target) const;

  void bind_array(GLuint array);
  void enable(GLuint index, bool on);
  /// Throws InputError where glVertexAttribPointer would have no bound array, no bound buffer, or
  /// another shape than GL takes.
  void check_pointer(GLint size, GLsizei stride) const;
  /// glVertexAttribPointer, after that check.
  void point(GLuint index, GLint size, GLenum type, GLsizei stride, GLsizeiptr offset);

  void remove_buffer(GLuint buffer);
  void remove_array(GLuint array);

  /// Throw InputError with what is missing where the draw would read past a buffer's end.
  void check_arrays(GLint first, GLsizei count) const;
  /// `restart` is the index that names no vertex where GL_PRIMITIVE_RESTART is enabled.
  void check_elements(GLsizei count, GLenum type, GLsizeiptr offset,
                      std::optional<GLuint> restart) const;

  /// Nothing is bound, as at a frame's begin; buffers and arrays stay.
  void unbind();

 private:
  struct Attribute {
    bool enabled = false;
    GLuint buffer = 0;
    std::size_t element = 0;  ///< bytes of one attribute
    std::size_t stride = 0;
    std::size_t offset = 0;
  };
  struct Array {
    GLuint elements = 0;
    std::map<GLuint, Attribute> attributes;
  };
  const Array& current(const char* what) const;
  std::vector<std::byte>& contents(GLenum target);
  void check_reach(const Array& array, std::uint64_t last_vertex) const;

  std::map<GLuint, std::vector<std::byte>> buffers_;
  std::map<GLuint, Array> arrays_;
  GLuint array_ = 0;
  GLuint array_buffer_ = 0;
};

}  // namespace shadowlab::gl
