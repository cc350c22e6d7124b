#include "gl/main_frame.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/error.h"

namespace shadowlab::gl {
namespace {

GLuint texture(const Functions& gl, GLenum internal, GLenum format, GLenum type, int width,
               int height) {
  std::array<GLuint, 1> name{};
  gl.GenTextures.unrecorded(1, name);
  gl.BindTexture.unrecorded(GL_TEXTURE_2D, name[0]);
  gl.TexImage2D.unrecorded(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, {});
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TexParameteri.unrecorded(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  return name[0];
}

GLuint framebuffer(const Functions& gl, GLuint color, GLuint depth_stencil) {
  std::array<GLuint, 1> name{};
  gl.GenFramebuffers.unrecorded(1, name);
  gl.BindFramebuffer.unrecorded(GL_FRAMEBUFFER, name[0]);
  gl.FramebufferTexture2D.unrecorded(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  gl.FramebufferTexture2D.unrecorded(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                                     depth_stencil, 0);
  if (gl.CheckFramebufferStatus.unrecorded(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw MachineError("This GL context cannot draw to RGBA8 with 24-bit depth and 8-bit stencil.");
  }
  return name[0];
}

}  // namespace

MainFrame::MainFrame(const Functions& gl, CallContext& context, int width, int height)
    : gl_(gl), context_(context), width_(width), height_(height) {
  if (width < 1 || height < 1 || width > 16384 || height > 16384) {
    throw InputError("A picture is between 1x1 and 16384x16384 pixels.");
  }
  color_ = texture(gl, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
  depth_stencil_ =
      texture(gl, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, width, height);
  gl.BindTexture.unrecorded(GL_TEXTURE_2D, 0);
  reader_ = framebuffer(gl, color_, depth_stencil_);
  frame_ = framebuffer(gl, color_, depth_stencil_);
  context_.main_frame = frame_;
}

void MainFrame::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  const auto allocate = [&](GLuint texture_name, GLenum internal, GLenum format, GLenum type) {
    gl_.BindTexture.unrecorded(GL_TEXTURE_2D, texture_name);
    gl_.TexImage2D.unrecorded(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, {});
  };
  allocate(color_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  allocate(depth_stencil_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  gl_.BindTexture.unrecorded(GL_TEXTURE_2D, 0);
  width_ = width;
  height_ = height;
}

MainFrame::~MainFrame() {
  gl_.DeleteFramebuffers.unrecorded(2, std::array<GLuint, 2>{frame_, reader_});
  gl_.DeleteTextures.unrecorded(2, std::array<GLuint, 2>{color_, depth_stencil_});
  context_.main_frame = 0;
}

void MainFrame::read(Box box, GLenum format, GLenum type, std::size_t pixel_bytes,
                     std::byte* top) const {
  context_.context->make_current();
  std::array<GLint, 2> before{};
  gl_.GetIntegerv.unrecorded(GL_READ_FRAMEBUFFER_BINDING, std::span(before).first(1));
  gl_.GetIntegerv.unrecorded(GL_PACK_ALIGNMENT, std::span(before).last(1));
  gl_.BindFramebuffer.unrecorded(GL_READ_FRAMEBUFFER, reader_);
  gl_.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, 1);
  const std::size_t row = pixel_bytes * static_cast<std::size_t>(box.width);
  const std::size_t rows = static_cast<std::size_t>(box.height);
  gl_.ReadPixels.unrecorded(box.x, box.y, box.width, box.height, format, type,
                            std::span(top, row * rows));
  // GL's first row is the lowest.
  for (std::size_t low = 0, high = rows - 1; low < high; ++low, --high) {
    std::swap_ranges(top + low * row, top + (low + 1) * row, top + high * row);
  }
  gl_.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, before[1]);
  gl_.BindFramebuffer.unrecorded(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before[0]));
}

image::Image MainFrame::read_color() const {
  image::Image image(width_, height_);
  read(all(), GL_RGBA, GL_UNSIGNED_BYTE, 4, reinterpret_cast<std::byte*>(image.rgba.data()));
  return image;
}

image::FloatImage MainFrame::read_depth() const {
  image::FloatImage image{width_, height_, {}};
  image.values.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  read(all(), GL_DEPTH_COMPONENT, GL_FLOAT, sizeof(float),
       reinterpret_cast<std::byte*>(image.values.data()));
  return image;
}

std::vector<std::uint8_t> MainFrame::read_stencil() const {
  std::vector<std::uint8_t> stencil(static_cast<std::size_t>(width_) *
                                    static_cast<std::size_t>(height_));
  read(all(), GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, reinterpret_cast<std::byte*>(stencil.data()));
  return stencil;
}

MainFrame::Pixel MainFrame::read_pixel(int x, int y) const {
  Pixel pixel;
  const Box box{x, height_ - 1 - y, 1, 1};
  read(box, GL_RGBA, GL_UNSIGNED_BYTE, 4, reinterpret_cast<std::byte*>(pixel.rgba.data()));
  read(box, GL_DEPTH_COMPONENT, GL_FLOAT, sizeof(float),
       reinterpret_cast<std::byte*>(&pixel.depth));
  read(box, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, reinterpret_cast<std::byte*>(&pixel.stencil));
  return pixel;
}

}  // namespace shadowlab::gl
