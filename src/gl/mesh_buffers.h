// Meshes on their way to GL: vertex arrays, made when a mesh is first drawn.
#pragma once

#include <map>
#include <memory>

#include "gl/functions.h"
#include "scene/mesh.h"

namespace shadowlab::gl {

/// The vertex array of one mesh: position at location 0, normal at 1, uv at 2, interleaved.
class MeshBuffers {
 public:
  MeshBuffers(const Functions& gl, CallContext& context, const scene::Mesh& mesh);
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// One glDrawElements with the current program and state; the vertex array stays bound.
  void draw() const;

 private:
  const Functions& gl_;
  GLuint vertex_array_ = 0;
  std::array<GLuint, 2> buffers_{};
  GLsizei count_ = 0;
};

/// The buffers of the meshes that are alive, one for each mesh however many objects share it.
class MeshCache {
 public:
  MeshCache(const Functions& gl, CallContext& context) : gl_(gl), context_(context) {}
  const MeshBuffers& get(const std::shared_ptr<const scene::Mesh>& mesh);
  /// Frees the buffers of meshes that nobody holds any more; as many new ones make it do so by
  /// itself.
  void sweep();
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::weak_ptr<const scene::Mesh> mesh;
    std::unique_ptr<MeshBuffers> buffers;
  };
  const Functions& gl_;
  CallContext& context_;
  std::map<const scene::Mesh*, Entry> entries_;
  std::size_t sweep_at_ = 64;
};

}  // namespace shadowlab::gl
