// What texels, pixels and their numbers take in memory.
#pragma once

#include <GL/glcorearb.h>

#include <cstddef>
#include <cstdint>

namespace shadowlab::gl {

/// Bytes that a texel of `internal` may take: those of tables 8.12 and 8.13 of OpenGL 4.5, three
/// components padded to four and small formats to four bytes, as drivers may keep them; 16, the
/// most that there is, for a format that is not known here.
constexpr std::uint64_t texel_bytes(GLenum internal) {
  switch (internal) {
    case GL_R8:
    case GL_RG8:
    case GL_RGB8:
    case GL_RGBA8:
    case GL_RGBA8_SNORM:
    case GL_SRGB8_ALPHA8:
    case GL_RGB10_A2:
    case GL_R11F_G11F_B10F:
    case GL_R16F:
    case GL_RG16F:
    case GL_R32F:
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT16:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32:
    case GL_DEPTH_COMPONENT32F:
    case GL_DEPTH24_STENCIL8:
    case GL_STENCIL_INDEX8:
      return 4;
    case GL_RGB16F:
    case GL_RGBA16F:
    case GL_RGBA16_SNORM:
    case GL_RG32F:
    case GL_DEPTH32F_STENCIL8:
      return 8;
    default:
      return 16;
  }
}

/// Numbers of a pixel of `format` (OpenGL 4.5, table 8.3). 1 for depth with stencil, which is
/// packed into one.
constexpr std::size_t components_of(GLenum format) {
  switch (format) {
    case GL_RG:
    case GL_RG_INTEGER:
      return 2;
    case GL_RGB:
    case GL_BGR:
    case GL_RGB_INTEGER:
      return 3;
    case GL_RGBA:
    case GL_BGRA:
    case GL_RGBA_INTEGER:
      return 4;
    default:
      return 1;
  }
}

/// Bytes of one number of `type`.
constexpr std::size_t bytes_of_type(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

}  // namespace shadowlab::gl
