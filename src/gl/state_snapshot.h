// GL's state at one moment, and the calls that make it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gl/functions.h"

namespace shadowlab::gl {

/// What decides about the fragments of a draw: tests, masks, blending, culling, where they go.
struct StateSnapshot {
  struct StencilFace {
    GLint func, ref, value_mask, fail, depth_fail, depth_pass, write_mask;
    bool operator==(const StencilFace&) const = default;
  };
  std::vector<bool> enabled;             ///< in the order of Capability::values
  std::array<StencilFace, 2> stencil{};  ///< front, back
  GLint depth_func = 0, cull_face = 0, front_face = 0, logic_op = 0, program = 0;
  std::array<GLint, 2> polygon_mode{}, framebuffers{};  ///< framebuffers: draw, read
  std::array<GLint, 4> blend{};                         ///< source, destination, of RGB and alpha
  std::array<GLint, 2> blend_equation{};
  std::array<GLboolean, 4> color_mask{};
  GLboolean depth_mask = 0;
  std::array<GLfloat, 2> depth_range{}, polygon_offset{};
  GLfloat line_width = 0, point_size = 0;
  std::array<GLfloat, 4> blend_color{};
  std::array<GLint, 4> viewport{}, scissor{};
  std::array<GLint, 16> texture_2d{}, texture_cube{};  ///< by unit; 0: none
  bool operator==(const StateSnapshot&) const = default;
};

/// The state now. Asks alone: nothing is changed but the active texture unit, which is put back.
StateSnapshot state_now(const Functions& gl);

/// One line of C for each part of the state, always as many and in the same order, so that two
/// snapshots are compared line by line: `glDepthFunc(GL_LESS);`. A part that is not there (no
/// texture) is an empty line. Framebuffer `main_frame` is 0.
std::vector<std::string> as_c(const StateSnapshot& state, GLuint main_frame);

}  // namespace shadowlab::gl
