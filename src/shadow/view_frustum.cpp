#include "shadow/view_frustum.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow {
namespace {

// Corners of each side in order around it.
constexpr std::array<std::array<std::size_t, 4>, 6> sides{
    {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}};

// The planes of a frustum's sides, turned toward its middle.
Planes planes_of(const std::array<glm::dvec3, 8>& corners) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& corner : corners) middle += corner / 8.0;
  Planes planes;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& side = sides[i];
    const glm::dvec3 a = corners[side[2]] - corners[side[0]],
                     b = corners[side[3]] - corners[side[1]];
    glm::dvec3 normal = glm::cross(a, b);
    if (glm::dot(normal, middle - corners[side[0]]) < 0) normal = -normal;
    const double length = glm::length(normal);
    if (length > 0) normal /= length;
    planes[i] = glm::dvec4(normal, -glm::dot(normal, corners[side[0]]));
  }
  return planes;
}

double signed_distance(glm::dvec4 plane, glm::dvec3 point) {
  return glm::dot(glm::dvec3(plane), point) + plane.w;
}

void append_clipped(const Hexahedron& shape, const Hexahedron& by, std::vector<Polygon>& out) {
  ClipScratch scratch;
  std::array<glm::dvec3, 4> polygon;
  for (const auto& side : sides) {
    for (std::size_t i = 0; i < 4; ++i) polygon[i] = shape.corners[side[i]];
    const auto rest = clipped(polygon, by.planes, scratch);
    if (!rest.empty()) out.emplace_back(rest.begin(), rest.end());
  }
}

}  // namespace

Polygon clipped(std::span<const glm::dvec3> polygon, glm::dvec4 plane) {
  ClipScratch scratch;
  const auto inside = clipped(polygon, {&plane, 1}, scratch);
  return {inside.begin(), inside.end()};
}

std::span<const glm::dvec3> clipped(std::span<const glm::dvec3> polygon,
                                    std::span<const glm::dvec4> planes, ClipScratch& scratch) {
  std::span<const glm::dvec3> rest = polygon;
  for (const glm::dvec4& plane : planes) {
    const auto before = [&](glm::dvec3 p) { return signed_distance(plane, p) >= 0; };
    if (std::ranges::all_of(rest, before)) continue;
    scratch.next.clear();
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const glm::dvec3 p = rest[i], q = rest[(i + 1) % rest.size()];
      const double dp = signed_distance(plane, p), dq = signed_distance(plane, q);
      if (dp >= 0) scratch.next.push_back(p);
      if ((dp >= 0) != (dq >= 0)) scratch.next.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    std::swap(scratch.now, scratch.next);
    rest = scratch.now;
  }
  return rest;
}

std::array<Polygon, 6> sides_of(const Hexahedron& shape) {
  std::array<Polygon, 6> polygons;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const std::size_t corner : sides[i]) polygons[i].push_back(shape.corners[corner]);
  }
  return polygons;
}

Hexahedron frustum(const scene::Camera& camera, double aspect, double near, double far) {
  camera.projection(aspect);  // refuses what is no frustum
  const glm::dmat4 view = camera.view();
  const double half = std::tan(glm::radians(camera.fovy) / 2);
  Hexahedron shape;
  for (std::size_t i = 0; i < 8; ++i) {
    const double distance = (i & 4) ? far : near;
    const glm::dvec3 eye_space(((i & 1) ? 1 : -1) * half * aspect * distance,
                               ((i & 2) ? 1 : -1) * half * distance, -distance);
    // The view is a rotation about the eye.
    shape.corners[i] = camera.eye + glm::transpose(glm::dmat3(view)) * eye_space;
  }
  shape.planes = planes_of(shape.corners);
  return shape;
}

Hexahedron hexahedron(const scene::Bounds& box) {
  Hexahedron shape;
  for (std::size_t i = 0; i < 8; ++i) {
    shape.corners[i] = {(i & 1) ? box.high.x : box.low.x, (i & 2) ? box.high.y : box.low.y,
                        (i & 4) ? box.high.z : box.low.z};
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const auto axis = static_cast<glm::length_t>(i / 2);
    glm::dvec4 plane(0);
    plane[axis] = i % 2 == 0 ? 1 : -1;
    plane.w = i % 2 == 0 ? -box.low[axis] : box.high[axis];
    shape.planes[i] = plane;
  }
  return shape;
}

std::vector<Polygon> common_sides(const Hexahedron& a, const Hexahedron& b) {
  std::vector<Polygon> polygons;
  append_clipped(a, b, polygons);
  append_clipped(b, a, polygons);
  return polygons;
}

std::vector<Polygon> visible_sides(const scene::Scene& scene, const Hexahedron& view) {
  std::vector<Polygon> visible;
  for (const scene::Object& object : scene.objects) {
    for (auto& side : common_sides(hexahedron(scene::bounds(*object.mesh, object.model)), view))
      visible.push_back(std::move(side));
  }
  return visible;
}

DepthRange depth_present(const scene::Scene& scene, const scene::Camera& camera, double aspect) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  DepthRange range{camera.far, camera.near};
  for (const Polygon& side :
       visible_sides(scene, frustum(camera, aspect, camera.near, camera.far))) {
    for (const glm::dvec3& corner : side) {
      const double depth = glm::dot(forward, corner - camera.eye);
      range.near = std::min(range.near, depth);
      range.far = std::max(range.far, depth);
    }
  }
  if (range.near > range.far) return {camera.near, camera.far};
  return {std::max(range.near, camera.near), std::min(range.far, camera.far)};
}

}  // namespace shadowlab::shadow
