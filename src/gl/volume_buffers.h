// Shadow volumes on their way to GL: vertices that never change, indices that follow the light.
#pragma once

#include <array>
#include <memory>
#include <span>

#include <glm/glm.hpp>

#include "gl/functions.h"

namespace shadowlab::gl {

/// The doubled vertices of one mesh, (p, 1) and (p, 0); shared by all volumes of that mesh.
class VolumeVertices {
 public:
  VolumeVertices(const Functions& gl, CallContext& context, std::span<const glm::vec4> vertices);
  ~VolumeVertices();
  VolumeVertices(const VolumeVertices&) = delete;
  VolumeVertices& operator=(const VolumeVertices&) = delete;
  GLuint name() const { return buffer_; }

 private:
  const Functions& gl_;
  GLuint buffer_ = 0;
};

/// One volume: a vertex array over shared vertices (vec4 at location 0) and its own indices.
class VolumeBuffers {
 public:
  VolumeBuffers(const Functions& gl, CallContext& context,
                std::shared_ptr<VolumeVertices> vertices);
  ~VolumeBuffers();
  VolumeBuffers(const VolumeBuffers&) = delete;
  VolumeBuffers& operator=(const VolumeBuffers&) = delete;

  /// Puts the indices in place of the last ones; GL's storage grows to the largest and stays.
  void upload(std::span<const std::uint32_t> indices);
  /// glDrawElements of `count` indices from `first`, with the current program and state.
  void draw(std::size_t first, std::size_t count) const;

 private:
  const Functions& gl_;
  CallContext& context_;
  std::shared_ptr<VolumeVertices> vertices_;
  GLuint vertex_array_ = 0;
  GLuint indices_ = 0;
  std::size_t capacity_ = 0;
};

/// Vertices and elements that never change, whatever the light does: what shaders extrude.
class FixedElements {
 public:
  /// Interleaved floats: `components[i]` of them at location i.
  FixedElements(const Functions& gl, CallContext& context, std::span<const float> vertices,
                std::span<const GLint> components, std::span<const std::uint32_t> indices);
  ~FixedElements();
  FixedElements(const FixedElements&) = delete;
  FixedElements& operator=(const FixedElements&) = delete;

  /// glDrawElements of `count` indices from `first`, with the current program and state.
  void draw(GLenum mode, std::size_t first, std::size_t count) const;

 private:
  const Functions& gl_;
  GLuint vertex_array_ = 0;
  std::array<GLuint, 2> buffers_{};
};

}  // namespace shadowlab::gl
