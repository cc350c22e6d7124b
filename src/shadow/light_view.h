// The light's view for a shadow map, fitted to what matters.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shadow/view_frustum.h"

namespace shadowlab::shadow {

/// World to the light's eye space and on to its clip space, depth to [-1, 1]: a perspective from a
/// point light, an orthographic one along a light at infinity.
struct LightView {
  glm::dmat4 view;
  glm::dmat4 projection;
  double near, far;  ///< distances from the light's eye along its axis
};

/// What a map is fitted to.
struct MapContent {
  /// What may show a shadow: the sides of convex pieces.
  std::vector<Polygon> receivers;
  /// Objects that may cast one, by their index in the scene; absent: all that cast.
  std::optional<std::vector<std::size_t>> casters;
};

/// What the camera sees, before all casters.
MapContent content_in_view(const scene::Scene& scene, const scene::Camera& camera, double aspect);
/// Everything, whatever the camera sees: a map that holds for every view.
MapContent whole_content(const scene::Scene& scene);

/// The tightest view, for this choice of axes, that holds every caster which can shadow one of
/// the receivers, as far as it can: in x and y the union of the casters' extents, each cut to the
/// receivers'; in depth from the nearest of those casters to the farthest receiver. So what is
/// outside of the map, and what is behind the light (w <= 0), is lit. One part in 100 is added
/// around it for filters, one in 1000 in depth for rounding. `light` in world space, w = 0 or w >
/// 0.
///
/// A point light needs one frustum that holds the casters, or else the receivers: throws InputError
/// where both reach around it by 85 degrees or more from every axis; six views (`cube_faces`) hold
/// them then. Throws as `normalized_light` too.
LightView light_view(glm::dvec4 light, const scene::Scene& scene, const MapContent& content);

/// How far on the map, in clip space, from what the light's centre sees in a direction that is
/// which its edge sees there, `radius` metres beside the centre: the nearest caster before the
/// farthest receiver. Of a point light's view.
double edge_reach(const LightView& view, double radius);

/// `view` with room around it for the parts of casters that only the light's edge sees. Throws
/// InputError for a light at infinity, which has no radius, and unless 0 <= radius, finite.
LightView with_room(LightView view, double radius);

/// The light's own axes: rows x, y and z of a rotation, z toward the light along `toward`, the same
/// for the same direction whatever the camera does.
glm::dmat3 light_axes(glm::dvec3 toward);

/// Six views of 90 degrees from a point light, in GL's order and with GL's axes of cube faces
/// (OpenGL 4.5, table 8.19): +x, -x, +y, -y, +z, -z, so that texture(samplerCube, world direction)
/// meets what was drawn. Throws InputError for a light at infinity and unless 0 < near < far.
std::array<LightView, 6> cube_faces(glm::dvec4 light, double near, double far);

/// Which of the six faces can hold a shadow that is seen: a caster meets the face's pyramid and a
/// receiver does.
std::array<bool, 6> faces_needed(glm::dvec4 light, const scene::Scene& scene,
                                 const MapContent& content);

/// The near and far of cube faces: as near as no caster is, on any face's axis (its distance from
/// the light over √3), but at least far/1e5, and as far as the farthest receiver.
DepthRange cube_range(glm::dvec4 light, const scene::Scene& scene, const MapContent& content);

}  // namespace shadowlab::shadow
