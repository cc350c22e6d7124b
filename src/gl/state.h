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

/// Remembers the state that a full-screen pass of the core touches, and puts it back at its end.
/// Between, depth and stencil tests, blending, culling and scissor are off and all colours written.
class SavedState {
 public:
  explicit SavedState(const Functions& gl);
  ~SavedState();
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

  /// The scissor box x, y, width, height that was in force, or nothing.
  std::optional<std::array<GLint, 4>> scissor() const;
  std::array<GLboolean, 4> color_mask() const { return color_mask_; }
  GLuint draw_framebuffer() const { return static_cast<GLuint>(draw_framebuffer_); }
  GLuint read_framebuffer() const { return static_cast<GLuint>(read_framebuffer_); }

 private:
  const Functions& gl_;
  std::vector<GLenum> enabled_;
  std::vector<GLuint> blended_;
  bool scissored_ = false;
  std::array<GLint, 4> scissor_{};
  std::array<GLint, 4> viewport_{};
  std::array<GLboolean, 4> color_mask_{};
  std::array<std::array<GLint, 2>, 2> bound_{};  ///< of units 0 and 1: texture, sampler
  GLint unit_ = 0, program_ = 0, vertex_array_ = 0, draw_framebuffer_ = 0, read_framebuffer_ = 0;
  GLint polygon_mode_ = GL_FILL;
};

}  // namespace shadowlab::gl
