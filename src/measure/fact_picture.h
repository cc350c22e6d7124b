// What a test sees of a frame: colour, depth and stencil at its end and after each of its passes.
//
// Pixels are named as GL's window coordinates name them: (0, 0) is the lower left one, y goes up,
// and the centre of pixel (x, y) is at (x + 0.5, y + 0.5).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/main_frame.h"
#include "lua/box.h"

namespace shadowlab::measure {

/// What the buffers held at one moment; rows from the top, as the images have them.
struct Snapshot {
  std::string pass;  ///< the pass that had just ended; "" for the end of the frame
  image::Image color;
  image::FloatImage depth;
  std::vector<std::uint8_t> stencil;
};

/// The lower left `width` × `height` pixels of `frame` now.
Snapshot look_at(const gl::MainFrame& frame, int width, int height, std::string pass);

/// A frame: its passes in order, then its end.
using Frame = std::vector<Snapshot>;

/// One of a frame's snapshots, as Lua holds it.
struct Picture {
  std::shared_ptr<const Frame> frame;
  std::size_t index;
  const Snapshot& snapshot() const { return (*frame)[index]; }
};

/// The end of the frame, pushed for Lua.
void push_picture(lua_State* L, Frame frame);

/// Makes Picture's metatable; once for a state.
void open_picture(lua_State* L);

}  // namespace shadowlab::measure

namespace shadowlab::lua {
template <>
struct BoxTraits<measure::Picture> {
  static constexpr const char* name = "picture";
  static bool push_field(lua_State*, measure::Picture&, std::string_view);
  static std::span<const std::string_view> fields();
};
}  // namespace shadowlab::lua
