// What the pointer takes hold of in the picture, and where it drags it.
#pragma once

#include <cstddef>
#include <optional>

#include "live/orbit.h"

namespace shadowlab::live {

/// Where a light is shown and held: a point light where it is, one at infinity half as far from
/// what the camera looks at as the camera is.
glm::dvec3 light_handle(glm::dvec4 light, const scene::Camera& camera);
/// The light whose handle that is.
glm::dvec4 light_of_handle(glm::dvec3 handle, glm::dvec4 light, const scene::Camera& camera);

/// The first caster on the ray, one that is not only a receiver, and where.
struct Hit {
  std::size_t object;
  glm::dvec3 point;
};
std::optional<Hit> first_caster(const scene::Scene& scene, const Ray& ray);

/// Where the ray meets the plane through `point`; nothing where it runs along it or away from it.
std::optional<glm::dvec3> on_plane(const Ray& ray, glm::dvec3 point, glm::dvec3 normal);

}  // namespace shadowlab::live
