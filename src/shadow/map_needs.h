// What a shadow map needs for one view of the scene, found from boxes: the casters that a lookup at
// what is seen can meet. A map without the others gives the same answers there, bit for bit, so
// long as its view and projection stay what they are: fitted to all.
//
//  - A lookup at a point reads texels around it, each of them drawn along its own ray from the
//    light. A caster on such a ray, before the point, is at most a filter's half width and half a
//    texel beside the point's own way to the light: so where the caster, grown by that, shadows no
//    box that is seen, no lookup there meets it.
//  - What is outside of the map's window leaves no fragment there.
//  - A map that no caster is needed in is read by nobody: whatever it holds, all is lit.
//
// Sources: as shadow/plan.h; M. Stamminger, J. Kautz in J. Bittner et al., Shadow Caster Culling
// for Efficient Shadow Mapping, I3D 2011 (casters by what visible receivers see of the light).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shadow/sight.h"

namespace shadowlab::shadow {

/// A map as it is drawn and read.
struct MapUse {
  glm::dmat4 to_clip;              ///< world space to the map's clip space
  int size = 1;                    ///< texels a side
  double filter = 1;               ///< texels across that a lookup reads, as map_bias takes it
  std::optional<DepthRange> part;  ///< where along the camera's view it is read; absent: everywhere
};

struct MapNeeds {
  std::vector<std::size_t> casters;  ///< by their index in the scene, in its order
  bool read() const { return !casters.empty(); }
};

/// `light` in world space, w = 0 or w > 0, that `map` is drawn from. `picture` in pixels. The
/// filter may be moved by map_bias's normal offset. Errors as `plan`.
MapNeeds map_needs(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
                   glm::ivec2 picture, const MapUse& map);
/// The same of what a camera sees of this scene.
MapNeeds map_needs(const scene::Scene& scene, Sight sight, glm::dvec4 light, const MapUse& map);

/// At most how many of the map's texels the box under `model` covers.
std::int64_t covered_texels(const MapUse& map, const scene::Bounds& bounds,
                            const glm::dmat4& model);

}  // namespace shadowlab::shadow
