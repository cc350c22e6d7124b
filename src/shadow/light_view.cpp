#include "shadow/light_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "shadow/enclosing_cone.h"
#include "shadow/facing.h"

namespace shadowlab::shadow {
namespace {

constexpr double margin = 1.01;  // around the window
constexpr double depth_margin = 1e-3;
// No plane at right angles to the axis holds what is seen under 90 degrees from it.
const double widest = glm::radians(85.0);

// An extent in the map: x and y on the plane at distance 1 (perspective) or in metres, and depth
// along the axis.
struct MapExtent {
  glm::dvec2 low{+1e300}, high{-1e300};
  double near = +1e300, far = -1e300;
  bool empty() const { return low.x > high.x || low.y > high.y; }
  void add(glm::dvec3 p) {
    low = glm::min(low, glm::dvec2(p));
    high = glm::max(high, glm::dvec2(p));
    near = std::min(near, p.z);
    far = std::max(far, p.z);
  }
  void add(const MapExtent& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
    near = std::min(near, other.near);
    far = std::max(far, other.far);
  }
};

MapExtent common(const MapExtent& a, const MapExtent& b) {
  return {glm::max(a.low, b.low), glm::min(a.high, b.high), a.near, a.far};
}

// World space to map coordinates: x, y as MapExtent has them, z the depth.
class MapSpace {
 public:
  MapSpace(glm::dmat3 axes, glm::dvec3 origin, bool perspective)
      : axes_(axes), origin_(origin), perspective_(perspective) {}

  glm::dvec3 eye(glm::dvec3 point) const { return axes_ * (point - origin_); }

  /// The extent of a convex polygon's corners; of what is before `least_depth` alone.
  MapExtent extent(std::span<const glm::dvec3> polygon, double least_depth) const {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec3& corner : polygon) corners.push_back(eye(corner));
    if (perspective_) corners = clipped(corners, {0, 0, -1, -least_depth});
    MapExtent extent;
    for (const glm::dvec3& corner : corners) extent.add(map(corner));
    return extent;
  }

  glm::dvec3 map(glm::dvec3 eye) const {
    return perspective_ ? glm::dvec3(eye.x / -eye.z, eye.y / -eye.z, -eye.z)
                        : glm::dvec3(eye.x, eye.y, -eye.z);
  }

  LightView view(const MapExtent& window) const {
    LightView light{glm::dmat4(axes_), glm::dmat4(0), window.near, window.far};
    light.view[3] = glm::dvec4(-(axes_ * origin_), 1);
    const double near = window.near, far = window.far;
    const glm::dvec2 size = window.high - window.low, sum = window.high + window.low;
    glm::dmat4& p = light.projection;
    p[0][0] = 2 / size.x;
    p[1][1] = 2 / size.y;
    if (perspective_) {  // glFrustum with the window on the plane at distance 1
      p[2] = {sum.x / size.x, sum.y / size.y, -(far + near) / (far - near), -1};
      p[3][2] = -2 * far * near / (far - near);
    } else {
      p[2][2] = -2 / (far - near);
      p[3] = {-sum.x / size.x, -sum.y / size.y, -(far + near) / (far - near), 1};
    }
    return light;
  }

 private:
  glm::dmat3 axes_;
  glm::dvec3 origin_;
  bool perspective_;
};

std::vector<glm::dvec3> vertices_of(const scene::Object& object) {
  std::vector<glm::dvec3> vertices;
  vertices.reserve(object.mesh->positions.size());
  for (const glm::vec3& position : object.mesh->positions)
    vertices.emplace_back(object.model * glm::dvec4(glm::dvec3(position), 1));
  return vertices;
}

bool may_cast(const MapContent& content, const scene::Scene& scene, std::size_t object) {
  if (!content.casters) return scene.objects[object].casts();
  return std::find(content.casters->begin(), content.casters->end(), object) !=
         content.casters->end();
}

std::vector<std::vector<glm::dvec3>> casters_of(const scene::Scene& scene,
                                                const MapContent& content) {
  std::vector<std::vector<glm::dvec3>> casters;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (may_cast(content, scene, i)) casters.push_back(vertices_of(scene.objects[i]));
  }
  return casters;
}

// Casters beyond the least depth are exact; of one that reaches behind it its box is cut.
MapExtent caster_extent(const MapSpace& space, const std::vector<glm::dvec3>& vertices,
                        bool perspective, double least_depth) {
  MapExtent extent;
  scene::Bounds box;
  bool before = true;
  for (const glm::dvec3& vertex : vertices) {
    const glm::dvec3 eye = space.eye(vertex);
    if (perspective && -eye.z < least_depth) before = false;
    if (before) extent.add(space.map(eye));
    box.low = glm::min(box.low, vertex);
    box.high = glm::max(box.high, vertex);
  }
  if (before) return extent;
  extent = {};
  const Hexahedron shape = hexahedron(box);
  for (const auto& side : sides_of(shape)) {
    const MapExtent cut = space.extent(side, least_depth);
    if (!cut.empty()) extent.add(cut);
  }
  return extent;
}

// The union of what each caster can shadow: its extent cut to the receivers', if it begins before
// the farthest of them.
MapExtent window_of(const MapSpace& space, const MapContent& content,
                    const std::vector<std::vector<glm::dvec3>>& casters, bool perspective,
                    double least_depth) {
  MapExtent receivers;
  for (const auto& piece : content.receivers) {
    if (piece.empty()) continue;
    const MapExtent extent = space.extent(piece, least_depth);
    if (!extent.empty()) receivers.add(extent);
  }
  MapExtent window;
  if (receivers.empty()) return window;
  for (const auto& vertices : casters) {
    const MapExtent caster = caster_extent(space, vertices, perspective, least_depth);
    if (caster.empty() || caster.near > receivers.far) continue;
    const MapExtent shadowed = common(caster, receivers);
    if (!shadowed.empty()) window.add(shadowed);
  }
  window.far = receivers.far;
  return window;
}

// Room for filters and rounding; and some map where there is nothing to show, since a recipe draws
// one in any case.
MapExtent padded(MapExtent window, double least_depth, bool perspective) {
  if (window.empty() || window.near > window.far) {
    const double depth = perspective ? std::max(2 * least_depth, 1.0) : 1.0;
    return {glm::dvec2(-1), glm::dvec2(1), depth / 2, 2 * depth};
  }
  const glm::dvec2 center = (window.low + window.high) * 0.5;
  const double largest = std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  const glm::dvec2 half =
      glm::max((window.high - window.low) * (0.5 * margin), glm::dvec2(1e-6 * largest + 1e-12));
  // A flat caster that faces the light has no depth of its own: its width counts then.
  const double width = largest * (perspective ? window.far : 1.0);
  const double depth =
      std::max(depth_margin * std::max(window.far - window.near, 1e-2 * width), 1e-12);
  MapExtent wide{center - half, center + half, window.near - depth, window.far + depth};
  if (perspective) wide.near = std::max(wide.near, 0.5 * std::max(window.near, least_depth));
  return wide;
}

LightView along_direction(glm::dvec3 toward, const scene::Scene& scene, const MapContent& content) {
  // Relative to a point of the scene, so that a world far from its origin loses nothing.
  glm::dvec3 origin(0);
  std::size_t count = 0;
  for (const auto& piece : content.receivers) {
    for (const glm::dvec3& corner : piece) {
      origin += corner;
      ++count;
    }
  }
  if (count > 0) origin /= static_cast<double>(count);
  const MapSpace space(light_axes(toward), origin, false);
  return space.view(
      padded(window_of(space, content, casters_of(scene, content), false, 0), 0, false));
}

std::vector<glm::dvec3> all_points(const std::vector<std::vector<glm::dvec3>>& pieces) {
  std::vector<glm::dvec3> points;
  for (const auto& piece : pieces) points.insert(points.end(), piece.begin(), piece.end());
  return points;
}

LightView from_point(glm::dvec3 light, const scene::Scene& scene, const MapContent& content) {
  const auto receivers = all_points(content.receivers);
  const Cone seen = enclosing_cone(light, receivers);
  double farthest = 0;
  for (const glm::dvec3& point : receivers)
    farthest = std::max(farthest, glm::length(point - light));

  // Casters that no receiver is behind are left out before the axis is chosen.
  auto casters = casters_of(scene, content);
  std::erase_if(casters, [&](const auto& vertices) {
    const Cone cone = enclosing_cone(light, vertices);
    double nearest = 1e300;
    for (const glm::dvec3& vertex : vertices)
      nearest = std::min(nearest, glm::length(vertex - light));
    const bool apart = seen.half_angle + cone.half_angle < std::numbers::pi / 2 &&
                       angle(seen.axis, cone.axis) > seen.half_angle + cone.half_angle;
    return receivers.empty() || apart ||
           (cone.half_angle < widest && nearest * std::cos(2 * cone.half_angle) > farthest);
  });
  const Cone casting = enclosing_cone(light, all_points(casters));
  const Cone& cone = casting.half_angle <= widest ? casting : seen;
  if (cone.half_angle > widest) {
    throw InputError(
        "The light is among its casters, so that no single frustum from it holds them; use six "
        "views (shadow.cube_faces), or move the light.");
  }
  // What is nearer than this along the axis is not in the map: 24 bits of depth end there.
  const double least_depth = std::max(farthest * 1e-5, 1e-300);
  const MapSpace space(light_axes(-cone.axis), light, true);
  return space.view(
      padded(window_of(space, content, casters, true, least_depth), least_depth, true));
}

}  // namespace

MapContent content_in_view(const scene::Scene& scene, const scene::Camera& camera, double aspect) {
  return {visible_sides(scene, frustum(camera, aspect, camera.near, camera.far)), {}};
}

MapContent whole_content(const scene::Scene& scene) {
  MapContent content;
  for (const scene::Object& object : scene.objects) {
    for (auto& side : sides_of(hexahedron(scene::bounds(*object.mesh, object.model))))
      content.receivers.push_back(std::move(side));
  }
  return content;
}

glm::dmat3 light_axes(glm::dvec3 toward) {
  const glm::dvec3 z = glm::normalize(toward);
  const glm::dvec3 up = std::abs(z.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  const glm::dvec3 x = glm::normalize(glm::cross(up, z));
  return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

LightView light_view(glm::dvec4 light, const scene::Scene& scene, const MapContent& content) {
  light = normalized_light(light);
  if (light.w == 0) return along_direction(glm::dvec3(light), scene, content);
  return from_point(glm::dvec3(light) / light.w, scene, content);
}

double edge_reach(const LightView& view, double radius) {
  const double per_tangent = std::max(view.projection[0][0], view.projection[1][1]);
  return radius * (1 / view.near - 1 / view.far) * per_tangent;
}

LightView with_room(LightView view, double radius) {
  if (view.projection[2][3] == 0)
    throw InputError("A light at infinity has no radius: its rays are parallel.");
  if (!(radius >= 0 && std::isfinite(radius)))
    throw InputError(fmt::format("A light's radius is 0 or more; it is {}", radius));
  const double narrowing = 1 / (1 + edge_reach(view, radius));
  view.projection =
      glm::scale(glm::dmat4(1), glm::dvec3(narrowing, narrowing, 1)) * view.projection;
  return view;
}

}  // namespace shadowlab::shadow
