#include "gl/held.h"

#include <algorithm>

#include "gl/get.h"

namespace shadowlab::gl {
namespace {

// GL gives the lowest free names first, so all are found before a gap this long.
constexpr GLuint longest_gap = 4096;

template <class IsObject, class Visit>
void each(const IsObject& is_object, const Visit& visit) {
  for (GLuint name = 1, last = 0; name - last < longest_gap; ++name) {
    if (!is_object.unrecorded(name)) continue;
    last = name;
    visit(name);
  }
}

struct TextureKind {
  GLenum target, image, binding;
  std::uint64_t images;
};
constexpr TextureKind kinds[] = {
    {GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, 1},
    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_BINDING_CUBE_MAP, 6},
    {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, 1},
    {GL_TEXTURE_3D, GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, 1},
    {GL_TEXTURE_1D, GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, 1},
    {GL_TEXTURE_RECTANGLE, GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, 1},
};

// Bytes of a whole texel, from the bits of its channels; drivers pack depth and stencil so too.
std::uint64_t level_bytes(const Functions& gl, GLenum image, GLint level) {
  const auto of = [&](GLenum name) {
    GLint value = 0;
    gl.GetTexLevelParameteriv.unrecorded(image, level, name, {&value, 1});
    return static_cast<std::uint64_t>(value);
  };
  std::uint64_t bits = 0;
  for (const GLenum channel :
       {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
        GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE})
    bits += of(channel);
  return of(GL_TEXTURE_WIDTH) * of(GL_TEXTURE_HEIGHT) * of(GL_TEXTURE_DEPTH) * bits / 8;
}

// A texture binds to the one target that it was made for; the errors of the others are taken back.
std::uint64_t texture_bytes(const Functions& gl, GLuint name) {
  for (const TextureKind& kind : kinds) {
    const auto before = static_cast<GLuint>(integer(gl, kind.binding));
    gl.BindTexture.unrecorded(kind.target, name);
    if (gl.GetError.unrecorded() != GL_NO_ERROR) continue;
    std::uint64_t bytes = 0;
    for (GLint level = 0; level < 15; ++level) {
      const std::uint64_t more = level_bytes(gl, kind.image, level) * kind.images;
      if (more == 0) break;
      bytes += more;
    }
    gl.BindTexture.unrecorded(kind.target, before);
    return bytes;
  }
  return 0;
}

}  // namespace

Held held(const Functions& gl) {
  Held all;
  const auto buffer_before = static_cast<GLuint>(integer(gl, GL_ARRAY_BUFFER_BINDING));
  each(gl.IsBuffer, [&](GLuint name) {
    GLint bytes = 0;
    gl.BindBuffer.unrecorded(GL_ARRAY_BUFFER, name);
    gl.GetBufferParameteriv.unrecorded(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, {&bytes, 1});
    ++all.buffers.count;
    all.buffers.bytes += static_cast<std::uint64_t>(bytes);
  });
  gl.BindBuffer.unrecorded(GL_ARRAY_BUFFER, buffer_before);

  each(gl.IsTexture, [&](GLuint name) {
    ++all.textures.count;
    all.textures.bytes += texture_bytes(gl, name);
  });

  const auto renderbuffer_before = static_cast<GLuint>(integer(gl, GL_RENDERBUFFER_BINDING));
  each(gl.IsRenderbuffer, [&](GLuint name) {
    gl.BindRenderbuffer.unrecorded(GL_RENDERBUFFER, name);
    const auto of = [&](GLenum parameter) {
      GLint value = 0;
      gl.GetRenderbufferParameteriv.unrecorded(GL_RENDERBUFFER, parameter, {&value, 1});
      return static_cast<std::uint64_t>(value);
    };
    std::uint64_t bits = 0;
    for (const GLenum channel :
         {GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
          GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE})
      bits += of(channel);
    const std::uint64_t samples = std::max<std::uint64_t>(1, of(GL_RENDERBUFFER_SAMPLES));
    ++all.renderbuffers.count;
    all.renderbuffers.bytes +=
        of(GL_RENDERBUFFER_WIDTH) * of(GL_RENDERBUFFER_HEIGHT) * samples * bits / 8;
  });
  gl.BindRenderbuffer.unrecorded(GL_RENDERBUFFER, renderbuffer_before);
  return all;
}

}  // namespace shadowlab::gl
