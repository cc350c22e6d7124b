// What a window shows: pictures and panels, drawn in two dimensions to the context's own
// framebuffer.
//
//   Screen screen(graphics);
//   screen.begin(width, height, {0.1f, 0.1f, 0.1f});
//   screen.draw(triangles);
//   screen.finish();
//   context.window()->swap();
//
// It is drawn between a recipe's frames and leaves GL's state as it comes: the next frame begins
// with GL's defaults. The main frame is only read, so what is shown never changes what is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gl/graphics.h"
#include "image/image.h"

namespace shadowlab::gl {

/// A picture in GL that a screen can show.
class ShownPicture {
 public:
  explicit ShownPicture(Graphics& graphics) : graphics_(graphics) {}
  ~ShownPicture();
  ShownPicture(const ShownPicture&) = delete;
  ShownPicture& operator=(const ShownPicture&) = delete;

  /// The main frame's colours as they are now, copied within GL.
  void copy_main_frame();
  void upload(const image::Image& picture);

  GLuint texture() const { return texture_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void bind(int width, int height);

  Graphics& graphics_;
  GLuint texture_ = 0;
  int width_ = 0;
  int height_ = 0;
};

struct ScreenVertex {
  float x, y;  ///< pixels from the top left corner
  float u, v;
  std::uint32_t rgba;  ///< red in the lowest byte
};

/// Triangles of one texture within one rectangle.
struct ScreenBatch {
  enum class Alpha { blended, ignored };
  GLuint texture = 0;
  Alpha alpha = Alpha::blended;
  std::array<float, 4> clip{};  ///< left, top, right, bottom: pixels
  std::size_t first = 0;        ///< of the indices
  std::size_t count = 0;
  std::size_t first_vertex = 0;  ///< what index 0 means
};

struct ScreenTriangles {
  std::span<const ScreenVertex> vertices;
  std::span<const std::uint16_t> indices;
  std::span<const ScreenBatch> batches;
};

class Screen {
 public:
  explicit Screen(Graphics& graphics);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// A framebuffer of that size in one colour, unless it is `kept`.
  void begin(int width, int height, std::array<float, 3> background);
  /// Whether the framebuffer holds the frame that was finished last, so that what did not change
  /// since need not be drawn. A swap may leave anything in it; where drawing is software's work, a
  /// pixel in the lower left corner says which frame it is.
  bool kept() const { return kept_; }
  /// A rectangle (left, top, right, bottom: whole pixels) in the background's colour again.
  void clear(std::array<int, 4> rectangle);
  void draw(const ScreenTriangles& triangles);
  /// The frame is whole.
  void finish();
  /// What is on it.
  image::Image read() const;

 private:
  Graphics& graphics_;
  std::shared_ptr<Program> program_;
  UniformValues uniforms_;
  GLuint vertex_array_ = 0;
  std::array<GLuint, 2> buffers_{};  ///< vertices, indices
  using Bytes = std::array<std::uint8_t, 4>;
  Bytes mark() const;
  void scissor(int left, int top, int right, int bottom) const;

  int width_ = 0;
  int height_ = 0;
  std::array<float, 3> background_{};
  bool marks_ = false;  ///< frames are marked, since asking for a pixel costs next to nothing
  bool kept_ = false;   ///< see kept
  std::uint32_t finished_ = 0;  ///< frames
};

}  // namespace shadowlab::gl
