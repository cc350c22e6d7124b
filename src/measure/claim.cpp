#include "measure/claim.h"

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::measure {
namespace {

double radius_of(const recipe::Recipe& recipe, const std::filesystem::path& file) {
  for (const auto& [name, parameter] : recipe.parameters()) {
    if (name == "radius" && parameter.value.size() == 1) return parameter.value[0];
  }
  throw InputError(file.string() +
                   ": truth = \"soft\" needs a parameter radius, the light's; it has none");
}

}  // namespace

Claim claim_of(const recipe::Recipe& recipe, const std::filesystem::path& file) {
  const std::string& truth = recipe.description().truth;
  if (truth.empty()) {
    throw InputError(fmt::format(
        "{} is not held against a truth; a recipe says so by truth = \"hard\"", file.string()));
  }
  const bool soft = truth == "soft" || truth == "soft on receivers";
  if (!soft && truth != "hard" && truth != "hard on receivers") {
    throw InputError(fmt::format(
        "{}: truth is \"hard\" or \"soft\", either with \" on receivers\" after it, not \"{}\"",
        file.string(), truth));
  }
  Claim claim{.on_receivers = truth.ends_with("on receivers"), .radius = {}};
  if (soft) claim.radius = radius_of(recipe, file);
  return claim;
}

image::FloatImage visibility_of(const image::Image& picture) {
  image::FloatImage visibility{picture.width, picture.height, {}};
  visibility.values.resize(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < visibility.values.size(); ++i)
    visibility.values[i] = static_cast<float>(picture.rgba[4 * i]) / 255.0f;
  return visibility;
}

}  // namespace shadowlab::measure
