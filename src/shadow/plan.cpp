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
          glm::ivec2 picture) {
  return plan(scene, camera, light, Sight(scene, camera, picture));
}

Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light, Sight sight) {
  light = normalized_light(light);
  const Eye& eye = sight.eye();
  const std::vector<Body>& bodies = sight.bodies();
  Plan plan;
  Extent all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (!object.casts() || bodies[i].bounds.empty()) continue;
    const ShadowReach reach(bodies[i].crate, light);
    const Extent met = sight.met_by(reach, i);
    if (met.empty()) {
      const Extent covered = sight.covered_by(reach, i);
      plan.dropped.push_back({i,
                              covered.empty() ? Plan::Why::outside_view : Plan::Why::meets_nothing,
                              rectangle(covered, eye.size)});
      continue;
    }
    all.add(met);
    plan.casters.push_back(
        {i, apart_from_near_pyramid(camera, eye.aspect, light, bodies[i].bounds, object.model),
         rectangle(met, eye.size)});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].seen.empty()) plan.seen.push_back(i);
    if (bodies[i].shadowed) plan.shadowed.push_back(i);
  }
  plan.shadows = rectangle(all, eye.size);
  return plan;
}

}  // namespace shadowlab::shadow
