// What is in a framebuffer's attachments, for somebody who looks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/functions.h"
#include "image/image.h"

namespace shadowlab::gl {

/// The contents of one attachment as numbers: rows from the top, `channels` floats a pixel.
struct AttachmentContents {
  std::string name;  ///< "GL_COLOR_ATTACHMENT0", "GL_DEPTH_ATTACHMENT", "GL_STENCIL_ATTACHMENT"
  GLuint framebuffer = 0;
  int width = 0, height = 0;
  int channels = 1;           ///< 4 of a colour, 1 of depth and stencil
  std::vector<float> values;  ///< empty where they were not asked for
};

/// All attachments of `framebuffer` that can be read: complete ones with one sample a pixel, and of
/// layers and cube maps the face that is attached. `with_values` is the one whose values are read
/// too. Reads alone, and puts back every binding.
std::vector<AttachmentContents> read_attachments(const Functions& gl, GLuint framebuffer,
                                                 std::optional<std::size_t> with_values);

}  // namespace shadowlab::gl
