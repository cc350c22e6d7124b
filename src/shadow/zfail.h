// Whether z-pass would be wrong for a caster, and z-fail must be used.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "scene/mesh.h"
#include "scene/scene.h"

namespace shadowlab::shadow {

/// A plane parts two bodies: across `direction` (unit length) they are `gap` apart.
struct Parting {
  glm::dvec3 direction;
  double gap;
};

/// Z-pass counts from the near plane on, so it is right exactly where no point of the near
/// rectangle is in shadow: where no caster meets the pyramid from the near rectangle to the light
/// (for a direction, the prism toward it). What parts `bounds` (the caster's, in the space that
/// `model` leads from) from that pyramid, in world space; nothing where they meet: so whenever
/// z-pass could be wrong, and sometimes where it is not. `light` in world space, w ≥ 0. `aspect` is
/// width / height. Bounds grow by 1e-6 of the coordinates first, for the float arithmetic of GL.
/// Throws InputError where `model` is not invertible, or as `normalized_light`. Source: C. Everitt,
/// M. Kilgard, 2002, section 5; M. McGuire et al., Fast, Practical and Robust Shadows, 2003.
std::optional<Parting> apart_from_near_pyramid(const scene::Camera& camera, double aspect,
                                               glm::dvec4 light, const scene::Bounds& bounds,
                                               const glm::dmat4& model = glm::dmat4(1.0));

/// Whether nothing parts them.
inline bool needs_zfail(const scene::Camera& camera, double aspect, glm::dvec4 light,
                        const scene::Bounds& bounds, const glm::dmat4& model = glm::dmat4(1.0)) {
  return !apart_from_near_pyramid(camera, aspect, light, bounds, model);
}

/// The corners of the near rectangle in world space, in order around it.
std::array<glm::dvec3, 4> near_rectangle(const scene::Camera& camera, double aspect);

}  // namespace shadowlab::shadow
