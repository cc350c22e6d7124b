// What GL was given to do: draws, triangles, bytes sent. Counted in the function table itself, so
// that the core's own uploads count as a recipe's do.
#pragma once

#include <cstdint>
#include <type_traits>

#include "gl/kinds.h"

namespace shadowlab::gl {

/// Sums since the context was made; the difference of two is what happened between.
struct Work {
  std::uint64_t draws = 0;         ///< glDraw*
  std::uint64_t triangles = 0;     ///< handed to GL: before clipping, culling, geometry shaders
  std::uint64_t uploads = 0;       ///< calls that gave pixels, vertices or indices to GL
  std::uint64_t upload_bytes = 0;  ///< theirs

  Work operator-(const Work& earlier) const {
    return {draws - earlier.draws, triangles - earlier.triangles, uploads - earlier.uploads,
            upload_bytes - earlier.upload_bytes};
  }

  void add_draw(GLenum mode, GLsizei vertices, GLsizei instances) {
    ++draws;
    triangles += triangles_of(mode, vertices) * static_cast<std::uint64_t>(instances);
  }
  void add_upload(std::size_t bytes) {
    if (bytes == 0) return;  // storage alone
    ++uploads;
    upload_bytes += bytes;
  }

  /// Of one draw of so many vertices; 0 for lines and points.
  static std::uint64_t triangles_of(GLenum mode, GLsizei vertices) {
    const auto count = static_cast<std::uint64_t>(vertices);
    switch (mode) {
      case GL_TRIANGLES:
        return count / 3;
      case GL_TRIANGLE_STRIP:
      case GL_TRIANGLE_FAN:
        return count < 3 ? 0 : count - 2;
      case GL_TRIANGLES_ADJACENCY:
        return count / 6;
      case GL_TRIANGLE_STRIP_ADJACENCY:
        return count < 6 ? 0 : (count - 4) / 2;
      default:
        return 0;
    }
  }
};

}  // namespace shadowlab::gl
