// The main frame: the framebuffer object that 0 stands for.
//
// RGBA8 colour and 24-bit depth with 8-bit stencil, both textures: so every context on one driver
// gives the same pixels, every buffer can be looked at, and a window only shows it.
#pragma once

#include <array>
#include <cstdint>

#include "gl/functions.h"
#include "image/image.h"

namespace shadowlab::gl {

class MainFrame {
 public:
  /// Creates it in the current context; `context.main_frame` becomes its name.
  MainFrame(const Functions& gl, CallContext& context, int width, int height);
  ~MainFrame();
  MainFrame(const MainFrame&) = delete;
  MainFrame& operator=(const MainFrame&) = delete;

  /// Another size, with nothing in it; the framebuffer keeps its name.
  void resize(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  GLuint color() const { return color_; }                  ///< RGBA8 texture
  GLuint depth_stencil() const { return depth_stencil_; }  ///< DEPTH24_STENCIL8 texture

  // What is in it, rows from the top. Reading goes through a framebuffer of its own and puts back
  // every binding, so that looking never changes what is drawn; its context becomes current.
  image::Image read_color() const;
  image::FloatImage read_depth() const;  ///< window depth, 0 to 1
  std::vector<std::uint8_t> read_stencil() const;
  struct Pixel {
    std::array<std::uint8_t, 4> rgba{};
    float depth = 0;  ///< window depth
    std::uint8_t stencil = 0;
    bool operator==(const Pixel&) const = default;
  };
  /// The pixel x from the left and y from the top, which is inside.
  Pixel read_pixel(int x, int y) const;

 private:
  struct Box {
    int x, y, width, height;  ///< from the lower left, as GL has them
  };
  void read(Box box, GLenum format, GLenum type, std::size_t pixel_bytes,
            std::byte* rows_from_the_top) const;
  Box all() const { return {0, 0, width_, height_}; }

  const Functions& gl_;
  CallContext& context_;
  int width_;
  int height_;
  GLuint color_ = 0;
  GLuint depth_stencil_ = 0;
  GLuint frame_ = 0;
  GLuint reader_ = 0;  ///< the same attachments, for reading back
};

}  // namespace shadowlab::gl
