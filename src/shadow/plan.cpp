#include "shadow/plan.h"

#include "shadow/facing.h"
#include "shadow/sight.h"

namespace shadowlab::shadow {
namespace {

PixelRectangle rectangle(const Extent& extent, glm::dvec2 size) {
  const PixelSpan pixels = pixels_of(extent, size);
  const glm::ivec2 sides = pixels.last - pixels.first;
  return {pixels.first.x, pixels.first.y, sides.x, sides.y};
}

}  // namespace

Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
          glm::ivec2 picture, Reasons reasons) {
  return plan(scene, camera, light, Sight(scene, camera, picture), reasons);
}

Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light, Sight sight,
          Reasons reasons) {
  light = normalized_light(light);
  const Eye& eye = sight.eye();
  const std::vector<Body>& bodies = sight.bodies();
  Plan plan;
  Extent all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (!object.casts() || bodies[i].bounds.empty()) continue;
    const ShadowReach reach(bodies[i].crate, light);
    const bool seen = !bodies[i].seen.empty();
    const std::optional<bool> shows_unlit =
        seen ? sight.shows_unlit_side(i, light) : std::optional(false);
    const Extent met =
        sight.met_by(reach, i, shows_unlit ? Sight::Itself::left_out : Sight::Itself::met);
    const bool unlit = shows_unlit.value_or(true);
    if (unlit) all.add(sight.met_itself(i));
    if (met.empty() && !unlit) {
      Plan::Dropped dropped{i, seen ? Plan::Why::all_lit : Plan::Why::meets_nothing, {}};
      if (reasons == Reasons::told) {
        const Extent covered = sight.covered_by(reach, i);
        if (!seen && covered.empty()) dropped.why = Plan::Why::outside_view;
        dropped.covered = rectangle(covered, eye.size);
      }
      plan.dropped.push_back(dropped);
      continue;
    }
    all.add(met);
    Plan::Kept kept{i, {}, rectangle(met, eye.size), unlit};
    if (kept.scissor.area() > 0)
      kept.apart =
          apart_from_near_pyramid(camera, eye.aspect, light, bodies[i].bounds, object.model);
    plan.casters.push_back(kept);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].seen.empty()) plan.seen.push_back(i);
    if (bodies[i].shadowed) plan.shadowed.push_back(i);
  }
  plan.shadows = rectangle(all, eye.size);
  return plan;
}

}  // namespace shadowlab::shadow
