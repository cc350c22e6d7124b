// A recipe's picture against the exact truth, over cameras and lights.
//
// The stock shaders draw the visibility instead of their shading (white where lit), so that the
// picture itself is what the technique says of each pixel.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gl/graphics.h"
#include "image/image.h"
#include "recipe/recipe.h"
#include "truth/comparison.h"

namespace shadowlab::measure {

/// The camera and light of one comparison.
struct View {
  scene::Camera camera;
  glm::dvec4 light{0};
};

struct CheckOptions {
  std::optional<std::string> scene;
  std::vector<std::pair<std::string, std::string>> settings;  ///< parameters
  int views = 1;           ///< the scene's own, then seeded random ones
  std::uint64_t seed = 1;  ///< of the random views
  int per_pixel = 4;       ///< of the edge mask
  /// The nearest near plane of the random views, in radii of the casters' bounds. Depth of b bits
  /// tells surfaces at distance z apart by z^2 / (near 2^b): at 24 bits and a hundredth, by 1/10000
  /// of a caster four radii away.
  double nearest = 0.01;
};

/// Sums over the views.
struct CheckResult {
  std::string recipe;
  std::string scene;
  int views = 0;    ///< compared
  int outside = 0;  ///< left out: the recipe says that its technique does not hold there
  std::size_t pixels = 0;
  std::size_t wrong = 0;
  std::size_t wrong_beyond_edge = 0;
  std::size_t wrong_beyond_limit = 0;  ///< of those, what the recipe's own `limit` does not explain
  double rmse = 0;                     ///< over the pixels of all views
  /// The views with wrong pixels beyond an edge, and how many: the worst first.
  std::vector<std::pair<int, std::size_t>> wrong_views;
};

/// View `index` of a scene: 0 is its own camera with `light`; the others are random, seeded by
/// `seed` and `index`: cameras inside and around the scene, looking at it, near planes of `nearest`
/// to a third of the casters' radius that cut it; lights around it, one in four of them at
/// infinity.
View view_of(const scene::Scene& scene, glm::dvec4 light, std::uint64_t seed, int index,
             double nearest = CheckOptions{}.nearest);

/// Compares `recipe` in `graphics`. Throws InputError where the recipe fails or is not to be held
/// against a truth.
CheckResult check(gl::Graphics& graphics, const std::filesystem::path& recipe,
                  const CheckOptions& options);

/// What one view looks like, side by side: the technique, the truth, and the wrong pixels (red
/// beyond an edge, yellow at one).
image::Image picture_of(gl::Graphics& graphics, const std::filesystem::path& recipe,
                        const CheckOptions& options, int view);

}  // namespace shadowlab::measure
