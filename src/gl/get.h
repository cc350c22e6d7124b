// What GL answers about its state.
#pragma once

#include <array>

#include "gl/functions.h"

namespace shadowlab::gl {

/// The first number of the state `name`, as glGetIntegerv gives it. Is not recorded.
inline GLint integer(const Functions& gl, GLenum name) {
  std::array<GLint, 16> values{};  // the most that a name has
  gl.GetIntegerv.unrecorded(name, values);
  return values[0];
}

}  // namespace shadowlab::gl
