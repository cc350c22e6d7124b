// What a recipe claims of its picture: which truth it is to be held against, and where.
#pragma once

#include <filesystem>
#include <optional>

#include "image/image.h"
#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab::measure {

struct Claim {
  bool on_receivers = false;     ///< casters are not its business
  std::optional<double> radius;  ///< of the light, a sphere around "light"; absent: hard shadows

  bool soft() const { return radius.has_value(); }
  /// Whether the technique says anything of what a pixel sees.
  bool covers(const scene::Scene& scene, const truth::Surface& surface) const {
    return surface.hit() && !(on_receivers && scene.objects[surface.object].casts());
  }
};

/// By the recipe's `truth` and, where that is soft, its parameter `radius` as it is set now. Throws
/// InputError, naming `file`, for a recipe that is not to be held against a truth.
Claim claim_of(const recipe::Recipe& recipe, const std::filesystem::path& file);

/// A technique's visibility: the red of a picture in which the stock shaders draw it.
image::FloatImage visibility_of(const image::Image& picture);

}  // namespace shadowlab::measure
