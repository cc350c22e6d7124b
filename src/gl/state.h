// GL's fixed-function state: its defaults, and how the core's own passes leave no trace in it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gl/functions.h"

namespace shadowlab::gl {

/// Puts every state that the functions of functions.def can change back to GL's default
/// (OpenGL 4.5, chapter 23), binds the main frame and sets viewport and scissor to its size.
/// Objects stay.
void reset_state(const Functions& gl, int width, int height);

/// The targets of the queries that are under way.
std::vector<GLenum> active_queries(const Functions& gl);

/// Remembers the state that a full-screen pass of the core touches, and puts it back at its end.
/// Between, depth and stencil tests, blending and culling are off, the scissor box is everything
/// and all colours of the first draw buffer are written.
class SavedState {
 public:
  explicit SavedState(const Functions& gl);
  ~SavedState();
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

  /// The scissor box x, y, width, height that was in force, or nothing.
  std::optional<std::array<GLint, 4>> scissor() const;
  std::array<GLboolean, 4> color_mask() const { return color_mask_; }
  GLenum read_buffer() const { return static_cast<GLenum>(read_buffer_); }
  bool discards_rasterization() const;
  GLuint draw_framebuffer() const { return static_cast<GLuint>(draw_framebuffer_); }
  GLuint read_framebuffer() const { return static_cast<GLuint>(read_framebuffer_); }

 private:
  const Functions& gl_;
  std::vector<GLenum> enabled_;
  bool blended_ = false, scissored_ = false;
  std::array<GLint, 4> scissor_{};
  std::array<GLint, 4> viewport_{};
  std::array<GLboolean, 4> color_mask_{};
  std::array<std::array<GLint, 2>, 3> bound_{};  ///< of units 0 to 2: texture, sampler
  GLint unit_ = 0, program_ = 0, vertex_array_ = 0, draw_framebuffer_ = 0, read_framebuffer_ = 0,
        read_buffer_ = 0;
  GLint polygon_mode_ = GL_FILL;
};

}  // namespace shadowlab::gl
