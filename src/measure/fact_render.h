// A recipe's frame for a test.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/graphics.h"
#include "measure/fact_picture.h"

namespace shadowlab::measure {

/// How a test wants a recipe rendered.
struct RenderOptions {
  int width = 256, height = 256;
  std::optional<std::string> scene;                           ///< in place of the recipe's own
  std::vector<std::pair<std::string, std::string>> settings;  ///< parameters, as --set takes them
  int frames = 1;           ///< drawn one after the other, the last is kept
  double time = 0;          ///< of the first, seconds; the others follow 1/60 s apart
  bool visibility = false;  ///< the stock shaders draw the visibility: white where lit, else black
};

/// From Lua's table {size = {width, height}, scene = , set = {name = value}, frames = , time = ,
/// visibility = true}; nil is all defaults. Throws InputError for what it does not know.
RenderOptions read_render_options(lua_State* L, int index);

/// The recipe's last frame with all its passes. `graphics`, of that size, is current afterwards.
Frame render(gl::Graphics& graphics, const std::filesystem::path& recipe,
             const RenderOptions& options);

}  // namespace shadowlab::measure
