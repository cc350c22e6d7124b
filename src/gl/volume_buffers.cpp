#include "gl/volume_buffers.h"

#include <numeric>

namespace shadowlab::gl {
namespace {

// The bindings that an upload changes, as they were.
class Bindings {
 public:
  explicit Bindings(const Functions& gl) : gl_(gl) {
    gl.GetIntegerv.unrecorded(GL_VERTEX_ARRAY_BINDING, {&array_, 1});
    gl.GetIntegerv.unrecorded(GL_ARRAY_BUFFER_BINDING, {&buffer_, 1});
  }
  ~Bindings() {
    gl_.BindVertexArray.unrecorded(static_cast<GLuint>(array_));
    gl_.BindBuffer.unrecorded(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
  }
  Bindings(const Bindings&) = delete;
  Bindings& operator=(const Bindings&) = delete;

 private:
  const Functions& gl_;
  GLint array_ = 0;
  GLint buffer_ = 0;
};

}  // namespace

VolumeVertices::VolumeVertices(const Functions& gl, CallContext& context,
                               std::span<const glm::vec4> vertices)
    : gl_(gl) {
  const Untraced untraced(context);
  const Bindings bindings(gl);
  gl.GenBuffers(1, {&buffer_, 1});
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()),
                std::as_bytes(vertices), GL_STATIC_DRAW);
}

VolumeVertices::~VolumeVertices() { gl_.DeleteBuffers.unrecorded(1, {&buffer_, 1}); }

VolumeBuffers::VolumeBuffers(const Functions& gl, CallContext& context,
                             std::shared_ptr<VolumeVertices> vertices)
    : gl_(gl), context_(context), vertices_(std::move(vertices)) {
  const Untraced untraced(context);
  const Bindings bindings(gl);
  gl.GenVertexArrays(1, {&vertex_array_, 1});
  gl.GenBuffers(1, {&indices_, 1});
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_->name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), 0);
}

VolumeBuffers::~VolumeBuffers() {
  gl_.DeleteVertexArrays.unrecorded(1, {&vertex_array_, 1});
  gl_.DeleteBuffers.unrecorded(1, {&indices_, 1});
}

void VolumeBuffers::upload(std::span<const std::uint32_t> indices) {
  const Untraced untraced(context_);
  const Bindings bindings(gl_);
  gl_.BindVertexArray(vertex_array_);
  const auto bytes = std::as_bytes(indices);
  if (bytes.size() > capacity_) {
    capacity_ = bytes.size();
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), bytes,
                   GL_DYNAMIC_DRAW);
  } else if (!bytes.empty()) {
    gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes);
  }
}

void VolumeBuffers::draw(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  gl_.BindVertexArray(vertex_array_);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   static_cast<GLsizeiptr>(first * sizeof(std::uint32_t)));
}

FixedElements::FixedElements(const Functions& gl, CallContext& context,
                             std::span<const float> vertices, std::span<const GLint> components,
                             std::span<const std::uint32_t> indices)
    : gl_(gl) {
  const Untraced untraced(context);
  const Bindings bindings(gl);
  gl.GenVertexArrays(1, {&vertex_array_, 1});
  gl.GenBuffers(2, buffers_);
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()),
                std::as_bytes(vertices), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
                std::as_bytes(indices), GL_STATIC_DRAW);
  const GLint all = std::accumulate(components.begin(), components.end(), 0);
  GLint before = 0;
  for (GLuint location = 0; location < components.size(); ++location) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components[location], GL_FLOAT, GL_FALSE,
                           all * static_cast<GLsizei>(sizeof(float)),
                           before * static_cast<GLsizeiptr>(sizeof(float)));
    before += components[location];
  }
}

FixedElements::~FixedElements() {
  gl_.DeleteVertexArrays.unrecorded(1, {&vertex_array_, 1});
  gl_.DeleteBuffers.unrecorded(2, buffers_);
}

void FixedElements::draw(GLenum mode, std::size_t first, std::size_t count) const {
  if (count == 0) return;
  gl_.BindVertexArray(vertex_array_);
  gl_.DrawElements(mode, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   static_cast<GLsizeiptr>(first * sizeof(std::uint32_t)));
}

}  // namespace shadowlab::gl
