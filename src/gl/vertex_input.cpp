#include "gl/vertex_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "gl/sizes.h"

namespace shadowlab::gl {
namespace {

std::uint64_t index_at(const std::byte* bytes, std::size_t size) {
  std::uint32_t wide = 0;
  std::memcpy(&wide, bytes, size);  // little-endian, as all machines that shadowlab runs on
  return wide;
}

}  // namespace

GLuint VertexInput::bound(GLenum target) const {
  if (target == GL_ARRAY_BUFFER) return array_buffer_;
  const auto array = arrays_.find(array_);
  return array == arrays_.end() ? 0 : array->second.elements;
}

void VertexInput::bind_buffer(GLenum target, GLuint buffer) {
  if (target == GL_ARRAY_BUFFER) {
    array_buffer_ = buffer;
  } else if (array_ == 0) {
    throw InputError(
        "gl.ELEMENT_ARRAY_BUFFER belongs to a vertex array; call gl.BindVertexArray first");
  } else {
    arrays_[array_].elements = buffer;
  }
  if (buffer) buffers_.try_emplace(buffer);
}

std::vector<std::byte>& VertexInput::contents(GLenum target) {
  const GLuint buffer = bound(target);
  if (buffer == 0) throw InputError("no buffer is bound to this target; call gl.BindBuffer first");
  return buffers_[buffer];
}

void VertexInput::set_data(GLenum target, std::size_t size, std::span<const std::byte> data) {
  std::vector<std::byte>& buffer = contents(target);
  buffer.assign(size, std::byte{0});
  std::copy(data.begin(), data.end(), buffer.begin());
}

void VertexInput::set_part(GLenum target, std::size_t offset, std::span<const std::byte> data) {
  std::vector<std::byte>& buffer = contents(target);
  if (offset > buffer.size() || data.size() > buffer.size() - offset) {
    throw InputError(fmt::format("bytes {} to {} do not fit into the buffer of {}", offset,
                                 offset + data.size(), buffer.size()));
  }
  std::copy(data.begin(), data.end(), buffer.begin() + static_cast<std::ptrdiff_t>(offset));
}

void VertexInput::bind_array(GLuint array) {
  array_ = array;
  if (array) arrays_.try_emplace(array);
}

const VertexInput::Array& VertexInput::current(const char* what) const {
  const auto array = arrays_.find(array_);
  if (array_ == 0 || array == arrays_.end()) {
    throw InputError(fmt::format("{} needs a vertex array; call gl.BindVertexArray first", what));
  }
  return array->second;
}

void VertexInput::enable(GLuint index, bool on) {
  current("this");
  arrays_[array_].attributes[index].enabled = on;
}

void VertexInput::check_pointer(GLint size, GLsizei stride) const {
  current("gl.VertexAttribPointer");
  if (array_buffer_ == 0) {
    throw InputError("no buffer is bound to gl.ARRAY_BUFFER; call gl.BindBuffer first");
  }
  if (size < 1 || size > 4) throw InputError("an attribute has 1 to 4 components");
  // OpenGL 4.5, table 23.55: GL_MAX_VERTEX_ATTRIB_STRIDE, under 4.4 without a limit.
  if (stride > 2048) throw InputError("the stride of an attribute is at most 2048 bytes");
}

void VertexInput::point(GLuint index, GLint size, GLenum type, GLsizei stride, GLsizeiptr offset) {
  Attribute& attribute = arrays_[array_].attributes[index];
  attribute.buffer = array_buffer_;
  attribute.element = static_cast<std::size_t>(size) * bytes_of_type(type);
  attribute.stride = stride == 0 ? attribute.element : static_cast<std::size_t>(stride);
  attribute.offset = static_cast<std::size_t>(offset);
}

void VertexInput::remove_buffer(GLuint buffer) {
  buffers_.erase(buffer);
  if (array_buffer_ == buffer) array_buffer_ = 0;
  // Arrays that are not bound keep the deleted buffer in GL; its name may be given out again, for
  // a buffer of another size. Here they have lost it, so that a draw from them is refused.
  for (auto& [name, array] : arrays_) {
    if (array.elements == buffer) array.elements = 0;
    for (auto& [index, attribute] : array.attributes) {
      if (attribute.buffer == buffer) attribute.buffer = 0;
    }
  }
}

void VertexInput::remove_array(GLuint array) {
  arrays_.erase(array);
  if (array_ == array) array_ = 0;
}

void VertexInput::check_reach(const Array& array, std::uint64_t last_vertex) const {
  for (const auto& [index, attribute] : array.attributes) {
    if (!attribute.enabled) continue;
    const auto buffer = buffers_.find(attribute.buffer);
    const std::uint64_t size = buffer == buffers_.end() ? 0 : buffer->second.size();
    const std::uint64_t needed =
        attribute.offset + last_vertex * attribute.stride + attribute.element;
    if (needed > size) {
      throw InputError(fmt::format(
          "vertex {} of attribute {} ends at byte {}, past its buffer's {} bytes; draw fewer "
          "vertices or upload more",
          last_vertex, index, needed, size));
    }
  }
}

void VertexInput::check_arrays(GLint first, GLsizei count) const {
  const Array& array = current("a draw");
  if (first < 0) throw InputError("the first vertex is not negative");
  if (count > 0)
    check_reach(array, static_cast<std::uint64_t>(first) + static_cast<std::uint64_t>(count) - 1);
}

void VertexInput::check_elements(GLsizei count, GLenum type, GLsizeiptr offset,
                                 std::optional<GLuint> restart) const {
  const Array& array = current("a draw");
  const auto buffer = buffers_.find(array.elements);
  if (array.elements == 0 || buffer == buffers_.end()) {
    throw InputError(
        "no buffer of indices is bound; call gl.BindBuffer(gl.ELEMENT_ARRAY_BUFFER, …) first");
  }
  const std::size_t each = bytes_of_type(type);
  const std::size_t size = buffer->second.size();
  const std::size_t needed = static_cast<std::size_t>(count) * each;
  if (offset < 0 || static_cast<std::size_t>(offset) > size ||
      needed > size - static_cast<std::size_t>(offset)) {
    throw InputError(
        fmt::format("{} indices from byte {} end past the buffer's {} bytes", count, offset, size));
  }
  std::optional<std::uint64_t> last;
  const std::byte* bytes = buffer->second.data() + offset;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::uint64_t index = index_at(bytes + i * each, each);
    if (index != restart) last = std::max(last.value_or(0), index);
  }
  if (last) check_reach(array, *last);
}

void VertexInput::unbind() {
  array_ = 0;
  array_buffer_ = 0;
}

}  // namespace shadowlab::gl
