#include "shadow/map_needs.h"

#include <algorithm>
#include <cmath>

#include "shadow/facing.h"
#include "shadow/sight.h"

namespace shadowlab::shadow {
namespace {

// The map's window on the world. Its clip coordinates are linear in the point: x = dot(row, (p,
// 1)).
class Window {
 public:
  explicit Window(const MapUse& map)
      : to_clip_(map.to_clip), reach_((1.5 * map.filter + 1) * 2 / map.size) {}

  /// Whether no point of the crate is drawn into it, nor read from it with the filter's reach.
  bool parts_from(const Crate& crate) const {
    for (glm::length_t axis = 0; axis < 2; ++axis) {
      for (const double side : {1.0, -1.0}) {
        bool beyond = true;
        for (std::size_t i = 0; i < 8 && beyond; ++i) {
          const glm::dvec4 clip = to_clip_ * glm::dvec4(crate.corner(i), 1);
          beyond = side * clip[axis] > clip.w + reach_ * std::abs(clip.w);
        }
        if (beyond) return true;
      }
    }
    return !in_front(crate);
  }

  /// The filter's reach at the crate, metres: half its width and half a texel, √2 of them for the
  /// normal offset (map_bias.h), across both axes of the map.
  double reach_at(const Crate& crate) const {
    const glm::dvec3 along(row(3));
    double farthest = 0;  // w: the distance along a perspective's axis, or 1
    for (std::size_t i = 0; i < 8; ++i)
      farthest = std::max(farthest, (to_clip_ * glm::dvec4(crate.corner(i), 1)).w);
    double square = 0;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
      glm::dvec3 across(row(axis));
      const double length = glm::dot(along, along);
      if (length > 0) across -= along * (glm::dot(across, along) / length);
      const double metres = reach_ * farthest / glm::length(across);
      square += metres * metres;
    }
    return std::sqrt(square);
  }

 private:
  bool in_front(const Crate& crate) const {
    for (std::size_t i = 0; i < 8; ++i) {
      if ((to_clip_ * glm::dvec4(crate.corner(i), 1)).w > 0) return true;
    }
    return false;
  }
  glm::dvec4 row(glm::length_t i) const {
    return {to_clip_[0][i], to_clip_[1][i], to_clip_[2][i], to_clip_[3][i]};
  }

  glm::dmat4 to_clip_;
  double reach_;  // in clip space at w = 1
};

}  // namespace

MapNeeds map_needs(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
                   glm::ivec2 picture, const MapUse& map) {
  return map_needs(scene, Sight(scene, camera, picture), light, map);
}

MapNeeds map_needs(const scene::Scene& scene, Sight sight, glm::dvec4 light, const MapUse& map) {
  light = normalized_light(light);
  const Window window(map);
  // Distances along the view are floats to the shader that chooses a map by them.
  std::optional<DepthRange> part = map.part;
  if (part) *part = {part->near * (1 - 1e-4), part->far * (1 + 1e-4)};
  sight.narrow(part, [&](const Crate& crate) { return !window.parts_from(crate); });
  MapNeeds needs;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    const Body& body = sight.bodies()[i];
    if (!object.casts() || body.bounds.empty() || window.parts_from(body.crate)) continue;
    const double reach = window.reach_at(body.crate);
    if (std::isfinite(reach)) {
      const Crate grown = crate_around(body.bounds, object.model, reach + body.room);
      if (!sight.is_met_by(ShadowReach(grown, light), grown)) continue;
    }
    needs.casters.push_back(i);
  }
  return needs;
}

std::int64_t covered_texels(const MapUse& map, const scene::Bounds& bounds,
                            const glm::dmat4& model) {
  const double size = map.size;
  glm::dvec2 low(size), high(0);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) ? bounds.high.x : bounds.low.x,
                            (i & 2) ? bounds.high.y : bounds.low.y,
                            (i & 4) ? bounds.high.z : bounds.low.z);
    const glm::dvec4 clip = map.to_clip * (model * glm::dvec4(corner, 1));
    if (!(clip.w > 0)) return std::int64_t{map.size} * map.size;
    const glm::dvec2 texel = (glm::dvec2(clip) / clip.w + 1.0) * (size / 2);
    low = glm::min(low, texel);
    high = glm::max(high, texel);
  }
  low = glm::clamp(glm::floor(low), 0.0, size);
  high = glm::clamp(glm::ceil(high), 0.0, size);
  if (high.x <= low.x || high.y <= low.y) return 0;
  return static_cast<std::int64_t>((high.x - low.x) * (high.y - low.y));
}

}  // namespace shadowlab::shadow
