#include "gl/mesh_buffers.h"

#include <algorithm>
#include <vector>

namespace shadowlab::gl {
namespace {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
};

}  // namespace

MeshBuffers::MeshBuffers(const Functions& gl, CallContext& context, const scene::Mesh& mesh)
    : gl_(gl), count_(static_cast<GLsizei>(mesh.indices.size())) {
  std::vector<Vertex> vertices(mesh.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i].position = mesh.positions[i];
    vertices[i].normal = mesh.normals.empty() ? glm::vec3(0) : mesh.normals[i];
    vertices[i].uv = mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[i];
  }
  const Untraced untraced(context);
  GLint bound_array = 0;
  GLint bound_buffer = 0;
  gl.GetIntegerv.unrecorded(GL_VERTEX_ARRAY_BINDING, {&bound_array, 1});
  gl.GetIntegerv.unrecorded(GL_ARRAY_BUFFER_BINDING, {&bound_buffer, 1});
  gl.GenVertexArrays(1, {&vertex_array_, 1});
  gl.GenBuffers(2, buffers_);
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  const auto vertex_bytes = std::as_bytes(std::span(vertices));
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertex_bytes.size()), vertex_bytes,
                GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  const auto index_bytes = std::as_bytes(std::span(mesh.indices));
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index_bytes.size()), index_bytes,
                GL_STATIC_DRAW);
  struct Attribute {
    GLint size;
    std::size_t offset;
  };
  const Attribute attributes[] = {
      {3, offsetof(Vertex, position)}, {3, offsetof(Vertex, normal)}, {2, offsetof(Vertex, uv)}};
  for (GLuint i = 0; i < 3; ++i) {
    gl.EnableVertexAttribArray(i);
    gl.VertexAttribPointer(i, attributes[i].size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                           static_cast<GLsizeiptr>(attributes[i].offset));
  }
  gl.BindVertexArray(static_cast<GLuint>(bound_array));
  gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound_buffer));
}

MeshBuffers::~MeshBuffers() {
  gl_.DeleteVertexArrays.unrecorded(1, {&vertex_array_, 1});
  gl_.DeleteBuffers.unrecorded(2, buffers_);
}

void MeshBuffers::draw() const {
  gl_.BindVertexArray(vertex_array_);
  gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, 0);
}

const MeshBuffers& MeshCache::get(const std::shared_ptr<const scene::Mesh>& mesh) {
  if (entries_.size() >= sweep_at_) sweep();
  Entry& entry = entries_[mesh.get()];
  // A new mesh may live where a dead one did.
  if (!entry.buffers || entry.mesh.lock() != mesh) {
    entry = {mesh, std::make_unique<MeshBuffers>(gl_, context_, *mesh)};
  }
  return *entry.buffers;
}

void MeshCache::sweep() {
  std::erase_if(entries_, [](const auto& item) { return item.second.mesh.expired(); });
  sweep_at_ = std::max<std::size_t>(64, 2 * entries_.size());
}

}  // namespace shadowlab::gl
