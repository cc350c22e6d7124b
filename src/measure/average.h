// Soft shadows that are an average of hard ones: held to the truth of the same points.
#pragma once

#include <span>

#include "measure/claim.h"
#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab::measure {

/// How many pixels of `drawn`, of the scene's own view, are no average of the hard shadows of
/// `points`: farther from theirs than by the points which the pixel may rightly take for lit or for
/// dark, since it is at an edge of that point's hard shadow, or within `limit` under it. So a light
/// of which a part is missing is found, however little that is beside a penumbra's own error.
std::size_t wrong_average(const scene::Scene& scene, const truth::Tracer& tracer,
                          const recipe::Limit& limit, const Claim& claim,
                          std::span<const glm::dvec4> points, const image::FloatImage& drawn);

}  // namespace shadowlab::measure
