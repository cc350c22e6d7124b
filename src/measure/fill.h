// Passes against the machine's fill limit: the pixels that a pass covers, times what a layer of
// pixels costs this machine, is the least that the pass can take.
//
// Both are measured in one run, in one context, at one size: so their ratio holds where times
// drift.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gl/graphics.h"
#include "recipe/recipe.h"

namespace shadowlab::measure {

/// What a covered pixel is given.
enum class Layer {
  color,    ///< a colour, by a shader that does nothing else (shaders/flat)
  shaded,   ///< a colour, by a shader that lights: at least what shaders/phong costs
  depth,    ///< depth alone: colour is masked out
  stencil,  ///< a depth test and a stencil operation: colour and depth are masked out
  count
};
constexpr std::size_t layer_count = static_cast<std::size_t>(Layer::count);
const char* name_of(Layer layer);

struct FillLimit {
  std::array<double, layer_count> layer{};  ///< milliseconds for 1 Mpix (1024²) of each kind
  double triangle = 0;  ///< nanoseconds for one of a few pixels, with the vertex stage of phong
  double pass = 0;      ///< milliseconds that a pass costs for being one: what glFinish waits for
};

/// Measures them in the main frame, which is left with something in it. Medians; takes about half a
/// second at 512².
FillLimit fill_limit(gl::Graphics& graphics);

/// One pass of a recipe, warm.
struct PassFill {
  std::string name;
  std::array<double, layer_count> mpix{};  ///< covered, tests aside: what was rasterised
  std::uint64_t triangles = 0;
  double milliseconds = 0;  ///< the median of `frames`
  std::uint64_t count = 1;  ///< how many passes it sums up

  double covered() const;
  /// The least time that filling takes, in milliseconds.
  double least(const FillLimit& limit) const;
  /// The same with the triangles' share and the pass's own.
  double least_in_all(const FillLimit& limit) const;
};

/// Draws one frame, each draw of it a second time without tests and writes in a query; the picture
/// is that of any frame. The passes have no times.
std::vector<PassFill> count_fill(gl::Graphics& graphics, recipe::Recipe& recipe);

/// Draws the recipe once to warm it, `frames` times for the times (which Options::time_passes must
/// have asked for), and once more for the pixels, as count_fill does.
std::vector<PassFill> fill_of(gl::Graphics& graphics, recipe::Recipe& recipe, int frames = 15);

}  // namespace shadowlab::measure
