// What a texel of an internal format takes in memory.
#pragma once

#include <GL/glcorearb.h>

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

}  // namespace shadowlab::gl
