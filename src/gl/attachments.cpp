#include "gl/attachments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "gl/get.h"

namespace shadowlab::gl {
namespace {

GLint parameter(const Functions& gl, GLenum attachment, GLenum what) {
  GLint value = 0;
  gl.GetFramebufferAttachmentParameteriv.unrecorded(GL_READ_FRAMEBUFFER, attachment, what,
                                                    {&value, 1});
  return value;
}

struct Size2 {
  int width = 0, height = 0;
};

// A blit or a read takes any size; what the attachment has, its object tells. Nothing for kinds of
// texture that cannot be asked for here.
std::optional<Size2> size_of(const Functions& gl, GLenum attachment) {
  const auto object =
      static_cast<GLuint>(parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  const GLint type = parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  Size2 size;
  if (type == GL_RENDERBUFFER) {
    const auto before = static_cast<GLuint>(integer(gl, GL_RENDERBUFFER_BINDING));
    gl.BindRenderbuffer.unrecorded(GL_RENDERBUFFER, object);
    GLint samples = 0;
    gl.GetRenderbufferParameteriv.unrecorded(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH,
                                             {&size.width, 1});
    gl.GetRenderbufferParameteriv.unrecorded(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT,
                                             {&size.height, 1});
    gl.GetRenderbufferParameteriv.unrecorded(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES,
                                             {&samples, 1});
    gl.BindRenderbuffer.unrecorded(GL_RENDERBUFFER, before);
    if (samples > 0) return {};
    return size;
  }
  if (type != GL_TEXTURE) return {};
  const GLint level = parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
  // A texture does not say of which kind it is: each is tried, and the wrong ones are GL errors.
  struct Kind {
    GLenum target, binding, image;
  };
  constexpr std::array kinds{
      Kind{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_2D},
      Kind{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X},
      Kind{GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_2D_ARRAY},
      Kind{GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_3D},
      Kind{GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, GL_TEXTURE_RECTANGLE}};
  for (const Kind& kind : kinds) {
    const auto before = static_cast<GLuint>(integer(gl, kind.binding));
    gl.BindTexture.unrecorded(kind.target, object);
    const bool right = gl.GetError.unrecorded() == GL_NO_ERROR;
    if (right) {
      gl.GetTexLevelParameteriv.unrecorded(kind.image, level, GL_TEXTURE_WIDTH, {&size.width, 1});
      gl.GetTexLevelParameteriv.unrecorded(kind.image, level, GL_TEXTURE_HEIGHT, {&size.height, 1});
    }
    gl.BindTexture.unrecorded(kind.target, before);
    if (right) return size;
  }
  return {};
}

void flip(std::vector<float>& values, std::size_t row) {
  const std::size_t rows = row == 0 ? 0 : values.size() / row;
  for (std::size_t low = 0; low + 1 < rows - low; ++low) {
    const auto at = [&](std::size_t y) {
      return values.begin() + static_cast<std::ptrdiff_t>(y * row);
    };
    std::swap_ranges(at(low), at(low + 1), at(rows - 1 - low));
  }
}

AttachmentContents read(const Functions& gl, GLenum attachment, Size2 size, GLenum format,
                        GLenum type) {
  AttachmentContents contents;
  contents.width = size.width;
  contents.height = size.height;
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  if (format == GL_STENCIL_INDEX) {
    std::vector<std::uint8_t> stencil(pixels);
    gl.ReadPixels.unrecorded(0, 0, size.width, size.height, format, GL_UNSIGNED_BYTE,
                             std::as_writable_bytes(std::span(stencil)));
    contents.values.assign(stencil.begin(), stencil.end());
  } else {
    contents.channels = format == GL_DEPTH_COMPONENT ? 1 : 4;
    if (contents.channels == 4) gl.ReadBuffer.unrecorded(attachment);
    contents.values.resize(pixels * static_cast<std::size_t>(contents.channels));
    if (type == GL_FLOAT) {
      gl.ReadPixels.unrecorded(0, 0, size.width, size.height, format, GL_FLOAT,
                               std::as_writable_bytes(std::span(contents.values)));
    } else {
      std::vector<std::int32_t> whole(contents.values.size());
      gl.ReadPixels.unrecorded(0, 0, size.width, size.height, GL_RGBA_INTEGER, type,
                               std::as_writable_bytes(std::span(whole)));
      std::ranges::transform(whole, contents.values.begin(),
                             [](std::int32_t v) { return static_cast<float>(v); });
    }
  }
  flip(contents.values,
       static_cast<std::size_t>(size.width) * static_cast<std::size_t>(contents.channels));
  return contents;
}

// Of an attachment that is there.
AttachmentContents read_one(const Functions& gl, GLenum attachment, Size2 size) {
  if (attachment == GL_DEPTH_ATTACHMENT)
    return read(gl, attachment, size, GL_DEPTH_COMPONENT, GL_FLOAT);
  if (attachment == GL_STENCIL_ATTACHMENT)
    return read(gl, attachment, size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
  const GLint type = parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
  const bool whole = type == GL_INT || type == GL_UNSIGNED_INT;
  return read(gl, attachment, size, GL_RGBA, whole ? static_cast<GLenum>(type) : GL_FLOAT);
}

std::string name_of_attachment(GLenum attachment) {
  for (const Constant& constant : Attachment::values) {
    if (constant.value == attachment) return fmt::format("GL_{}", constant.name);
  }
  return {};
}

}  // namespace

std::vector<AttachmentContents> read_attachments(const Functions& gl, GLuint framebuffer,
                                                 std::optional<std::size_t> with_values) {
  std::vector<AttachmentContents> all;
  const auto before = static_cast<GLuint>(integer(gl, GL_READ_FRAMEBUFFER_BINDING));
  const GLint alignment = integer(gl, GL_PACK_ALIGNMENT);
  gl.BindFramebuffer.unrecorded(GL_READ_FRAMEBUFFER, framebuffer);
  const auto read_buffer = static_cast<GLenum>(integer(gl, GL_READ_BUFFER));
  if (gl.CheckFramebufferStatus.unrecorded(GL_READ_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) {
    gl.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, 1);
    for (const Constant& attachment : Attachment::values) {
      if (attachment.value == GL_DEPTH_STENCIL_ATTACHMENT ||
          parameter(gl, attachment.value, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
        continue;
      const auto size = size_of(gl, attachment.value);
      if (!size || size->width < 1 || size->height < 1) continue;
      if (all.size() == with_values) {
        all.push_back(read_one(gl, attachment.value, *size));
      } else {
        all.push_back({});
        all.back().width = size->width;
        all.back().height = size->height;
      }
      all.back().name = name_of_attachment(attachment.value);
      all.back().framebuffer = framebuffer;
    }
    gl.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, alignment);
    gl.ReadBuffer.unrecorded(read_buffer);
  }
  gl.BindFramebuffer.unrecorded(GL_READ_FRAMEBUFFER, before);
  return all;
}

}  // namespace shadowlab::gl
