#include "gl/screen.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace shadowlab::gl {
namespace {

constexpr const char* vertex_text = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tint;
uniform vec2 size;
out vec2 at;
out vec4 color;
void main() {
  at = uv;
  color = tint;
  gl_Position = vec4(2.0 * place.x / size.x - 1.0, 1.0 - 2.0 * place.y / size.y, 0.0, 1.0);
}
)";

constexpr const char* fragment_text = R"(#version 330 core
in vec2 at;
in vec4 color;
uniform sampler2D shown;
uniform float opaque;
out vec4 fragment;
void main() {
  vec4 texel = texture(shown, at);
  fragment = color * vec4(texel.rgb, max(texel.a, opaque));
}
)";

template <class T>
std::span<const std::byte> bytes_of(std::span<const T> values) {
  return std::as_bytes(values);
}

void set_words(UniformValues& values, const Program& program, const char* name,
               std::initializer_list<float> words) {
  const Uniform* const uniform = program.find(name);
  if (!uniform) return;
  std::size_t at = uniform->first;
  for (const float word : words) std::memcpy(&values[at++], &word, sizeof word);
}

// The window's framebuffer, and not the main frame, which 0 is everywhere else.
void bind_own_framebuffer(const Functions& gl, GLenum target) {
  gl.BindFramebuffer.pointer(target, 0);
}

}  // namespace

ShownPicture::~ShownPicture() {
  graphics_.context().make_current();
  if (texture_) graphics_.gl.DeleteTextures.unrecorded(1, {&texture_, 1});
}

void ShownPicture::bind(int width, int height) {
  const Functions& gl = graphics_.gl;
  gl.ActiveTexture.unrecorded(GL_TEXTURE0);
  if (!texture_) {
    gl.GenTextures.unrecorded(1, {&texture_, 1});
    gl.BindTexture.unrecorded(GL_TEXTURE_2D, texture_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri.unrecorded(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      gl.TexParameteri.unrecorded(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
  gl.BindTexture.unrecorded(GL_TEXTURE_2D, texture_);
  if (width == width_ && height == height_) return;
  gl.TexImage2D.unrecorded(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                           {});
  width_ = width;
  height_ = height;
}

void ShownPicture::copy_main_frame() {
  const Functions& gl = graphics_.gl;
  graphics_.begin_frame();
  bind(graphics_.width(), graphics_.height());
  gl.CopyTexSubImage2D.unrecorded(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width_, height_);
}

void ShownPicture::upload(const image::Image& picture) {
  const Functions& gl = graphics_.gl;
  graphics_.begin_frame();
  // GL's first row is the lowest: as for a copy of the main frame.
  const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
  std::vector<std::uint8_t> rows(picture.rgba.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
    const auto from = picture.rgba.end() - static_cast<std::ptrdiff_t>((y + 1) * row);
    std::copy_n(from, row, rows.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  bind(picture.width, picture.height);
  gl.TexSubImage2D.unrecorded(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                              std::as_bytes(std::span(rows)));
}

Screen::Screen(Graphics& graphics)
    : graphics_(graphics),
      program_(graphics.programs.get(
          {{"screen.vert", vertex_text, {}}, {"screen.frag", fragment_text, {}}, {}})),
      uniforms_(program_->initial()) {
  const Functions& gl = graphics_.gl;
  // A GPU would have to end its work before a pixel can be asked for, and draws a panel in no time.
  for (const char* const software : {"llvmpipe", "softpipe"})
    marks_ = marks_ || graphics.context().renderer.find(software) != std::string::npos;
  gl.GenVertexArrays.unrecorded(1, {&vertex_array_, 1});
  gl.GenBuffers.unrecorded(2, buffers_);
}

Screen::~Screen() {
  graphics_.begin_frame();
  graphics_.gl.DeleteBuffers.unrecorded(2, buffers_);
  graphics_.gl.DeleteVertexArrays.unrecorded(1, {&vertex_array_, 1});
}

// The background, but for its last bits, which count the frames: nobody sees it.
Screen::Bytes Screen::mark() const {
  Bytes mark{0, 0, 0, 255};
  for (std::size_t i = 0; i < background_.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(std::lround(255 * background_[i]));
    mark[i] = static_cast<std::uint8_t>((byte & ~3u) | (finished_ >> (2 * i) & 3u));
  }
  return mark;
}

void Screen::scissor(int left, int top, int right, int bottom) const {
  graphics_.gl.Scissor.unrecorded(left, height_ - bottom, right - left, bottom - top);
}

void Screen::clear(std::array<int, 4> rectangle) {
  const auto [left, top, right, bottom] = rectangle;
  if (right <= left || bottom <= top) return;
  scissor(left, top, right, bottom);
  graphics_.gl.Clear.unrecorded(GL_COLOR_BUFFER_BIT);
}

void Screen::finish() {
  ++finished_;
  if (!marks_) return;
  const Bytes now = mark();
  const Functions& gl = graphics_.gl;
  scissor(0, height_ - 1, 1, height_);
  const auto part = [&](std::size_t i) { return static_cast<float>(now[i]) / 255; };
  gl.ClearColor.unrecorded(part(0), part(1), part(2), 1);
  gl.Clear.unrecorded(GL_COLOR_BUFFER_BIT);
}

void Screen::begin(int width, int height, std::array<float, 3> background) {
  const Functions& gl = graphics_.gl;
  graphics_.begin_frame();
  bind_own_framebuffer(gl, GL_FRAMEBUFFER);
  kept_ =
      marks_ && finished_ > 0 && width == width_ && height == height_ && background == background_;
  if (kept_) {
    Bytes there{};
    gl.ReadPixels.unrecorded(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                             std::as_writable_bytes(std::span(there)));
    there[3] = 255;
    kept_ = there == mark();
  }
  width_ = width;
  height_ = height;
  background_ = background;
  gl.Viewport.unrecorded(0, 0, width, height);
  gl.ClearColor.unrecorded(background[0], background[1], background[2], 1);
  if (!kept_) gl.Clear.unrecorded(GL_COLOR_BUFFER_BIT);
  gl.Enable.unrecorded(GL_BLEND);
  gl.BlendFunc.unrecorded(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable.unrecorded(GL_SCISSOR_TEST);
  gl.BindVertexArray.unrecorded(vertex_array_);
  gl.BindBuffer.unrecorded(GL_ARRAY_BUFFER, buffers_[0]);
  gl.BindBuffer.unrecorded(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  for (GLuint index = 0; index < 3; ++index) gl.EnableVertexAttribArray.unrecorded(index);
  set_words(uniforms_, *program_, "size", {static_cast<float>(width), static_cast<float>(height)});
}

void Screen::draw(const ScreenTriangles& triangles) {
  const Functions& gl = graphics_.gl;
  const auto vertices = bytes_of(triangles.vertices);
  const auto indices = bytes_of(triangles.indices);
  if (vertices.empty() || indices.empty()) return;
  gl.BufferData.unrecorded(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices,
                           GL_STREAM_DRAW);
  gl.BufferData.unrecorded(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size()),
                           indices, GL_STREAM_DRAW);
  for (const ScreenBatch& batch : triangles.batches) {
    const auto pixel = [](float value, int most) {
      return std::clamp(static_cast<int>(std::lround(value)), 0, most);
    };
    const int left = pixel(batch.clip[0], width_), right = pixel(batch.clip[2], width_);
    const int top = pixel(batch.clip[1], height_), bottom = pixel(batch.clip[3], height_);
    if (batch.count == 0 || right <= left || bottom <= top) continue;
    scissor(left, top, right, bottom);
    const bool opaque = batch.alpha == ScreenBatch::Alpha::ignored;
    set_words(uniforms_, *program_, "opaque", {opaque ? 1.0f : 0.0f});
    // Without blending a picture takes half the time in software.
    if (opaque) {
      gl.Disable.unrecorded(GL_BLEND);
    } else {
      gl.Enable.unrecorded(GL_BLEND);
    }
    program_->use(uniforms_);
    gl.BindTexture.unrecorded(GL_TEXTURE_2D, batch.texture);
    constexpr GLsizei stride = sizeof(ScreenVertex);
    const auto base = static_cast<GLsizeiptr>(batch.first_vertex * sizeof(ScreenVertex));
    gl.VertexAttribPointer.unrecorded(0, 2, GL_FLOAT, GL_FALSE, stride, base);
    gl.VertexAttribPointer.unrecorded(1, 2, GL_FLOAT, GL_FALSE, stride,
                                      base + static_cast<GLsizeiptr>(offsetof(ScreenVertex, u)));
    gl.VertexAttribPointer.unrecorded(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                                      base + static_cast<GLsizeiptr>(offsetof(ScreenVertex, rgba)));
    gl.DrawElements.unrecorded(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_SHORT,
                               static_cast<GLsizeiptr>(batch.first * sizeof(std::uint16_t)));
  }
}

image::Image Screen::read() const {
  const Functions& gl = graphics_.gl;
  graphics_.context().make_current();
  bind_own_framebuffer(gl, GL_READ_FRAMEBUFFER);
  gl.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, 1);
  image::Image picture(width_, height_);
  gl.ReadPixels.unrecorded(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                           std::as_writable_bytes(std::span(picture.rgba)));
  const std::size_t row = 4 * static_cast<std::size_t>(width_);
  for (std::size_t low = 0, high = static_cast<std::size_t>(height_); low + 1 < high; ++low) {
    --high;
    std::swap_ranges(picture.rgba.begin() + static_cast<std::ptrdiff_t>(low * row),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(high * row));
  }
  graphics_.begin_frame();
  return picture;
}

}  // namespace shadowlab::gl
