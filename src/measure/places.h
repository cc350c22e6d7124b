// The places that one pixel may have been taken for: what a technique's rounding comes to.
#pragma once

#include <vector>

#include "measure/caster_edges.h"
#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab::measure {

/// A scene under its first light and a technique's limit, and what of them all pixels of a picture
/// share. Keeps references to the first two.
struct LitScene {
  LitScene(const scene::Scene& scene, const truth::Tracer& tracer, const recipe::Limit& limit,
           int rows);

  const scene::Scene& scene;
  const truth::Tracer& tracer;
  recipe::Limit limit;
  int rows;  ///< of pixels
  scene::Scene caster_scene;
  truth::Tracer casters;  ///< of that
  std::vector<Edge> edges;
  double radius = 0;          ///< of the whole scene
  double light_rounding = 0;  ///< of the light's place, metres, as a caster's own floats have it

  glm::dvec4 light() const { return scene.lights[0].position; }
};

/// Whether some place that `surface`, of the scene's own view, may be taken for is lit, or is not:
/// Limits::allow says which places those are.
bool some_place_is(const LitScene& scene, const truth::Surface& surface, bool lit);

/// Whether a caster is where `surface` is, or so near behind it that depth cannot tell them apart.
bool is_as_near_as_a_caster(const LitScene& scene, const truth::Surface& surface);

}  // namespace shadowlab::measure
