#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "shadow/facing.h"
#include "shadow/light_view.h"

namespace shadowlab::shadow {
namespace {

struct FaceAxes {
  glm::dvec3 forward, up;
};
// The direction of each face's middle, and of its growing t turned over: t runs down the picture
// that GL draws, so up is -t (OpenGL 4.5, table 8.19: sc and tc by major axis).
constexpr std::array<FaceAxes, 6> faces{{{{1, 0, 0}, {0, -1, 0}},
                                         {{-1, 0, 0}, {0, -1, 0}},
                                         {{0, 1, 0}, {0, 0, 1}},
                                         {{0, -1, 0}, {0, 0, -1}},
                                         {{0, 0, 1}, {0, -1, 0}},
                                         {{0, 0, -1}, {0, -1, 0}}}};

glm::dmat3 axes_of(const FaceAxes& face) {
  const glm::dvec3 z = -face.forward;
  return glm::transpose(glm::dmat3(glm::cross(face.up, z), face.up, z));
}

glm::dvec3 place_of(glm::dvec4 light) {
  light = normalized_light(light);
  if (light.w == 0) {
    throw InputError(
        "A light at infinity shines one way: it has one view (shadow.light_view), no cube.");
  }
  return glm::dvec3(light) / light.w;
}

bool meets(const Polygon& polygon, glm::dvec3 light, const glm::dmat3& axes) {
  Polygon rest;
  for (const glm::dvec3& corner : polygon) rest.push_back(axes * (corner - light));
  for (const glm::dvec4& plane :
       {glm::dvec4(1, 0, -1, 0), {-1, 0, -1, 0}, {0, 1, -1, 0}, {0, -1, -1, 0}})
    rest = clipped(rest, plane);
  return !rest.empty();
}

// The least distance from p to a triangle: to its plane where p is over its inside, else to an
// edge.
double distance_to_triangle(glm::dvec3 p, const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area = glm::length(normal);
  bool over = area > 0;
  double least = 1e300;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 a = corners[i], edge = corners[(i + 1) % 3] - a;
    over = over && glm::dot(glm::cross(edge, p - a), normal) >= 0;
    const double square = glm::dot(edge, edge);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(a + edge * t - p));
  }
  return over ? std::abs(glm::dot(p - corners[0], normal)) / area : least;
}

double distance_to(const scene::Object& object, glm::dvec3 light) {
  const auto corner = [&](std::uint32_t index) {
    return glm::dvec3(object.model * glm::dvec4(glm::dvec3(object.mesh->positions[index]), 1));
  };
  double least = 1e300;
  const auto& indices = object.mesh->indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    least = std::min(least, distance_to_triangle(light, {corner(indices[i]), corner(indices[i + 1]),
                                                         corner(indices[i + 2])}));
  }
  return least;
}

}  // namespace

std::array<LightView, 6> cube_faces(glm::dvec4 light, double near, double far) {
  const glm::dvec3 place = place_of(light);
  if (!(near > 0 && far > near && std::isfinite(far)))
    throw InputError("The faces of a cube map take 0 < near < far, both finite.");
  std::array<LightView, 6> views;
  for (std::size_t i = 0; i < 6; ++i) {
    const glm::dmat3 axes = axes_of(faces[i]);
    LightView& face = views[i];
    face = {glm::dmat4(axes), glm::dmat4(1), near, far};
    face.view[3] = glm::dvec4(-(axes * place), 1);
    // 90 degrees: the cotangent of the half is 1, exactly, so that faces meet without a gap.
    face.projection[2] = {0, 0, -(far + near) / (far - near), -1};
    face.projection[3] = {0, 0, -2 * far * near / (far - near), 0};
  }
  return views;
}

std::array<bool, 6> faces_needed(glm::dvec4 light, const scene::Scene& scene,
                                 const MapContent& content) {
  const glm::dvec3 place = place_of(light);
  std::array<bool, 6> needed{};
  for (std::size_t i = 0; i < 6; ++i) {
    const glm::dmat3 axes = axes_of(faces[i]);
    const auto reached = [&](const Polygon& side) { return meets(side, place, axes); };
    if (!std::any_of(content.receivers.begin(), content.receivers.end(), reached)) continue;
    for (const scene::Object& object : scene.objects) {
      if (!object.casts() || needed[i]) continue;
      const auto sides = sides_of(hexahedron(scene::bounds(*object.mesh, object.model)));
      needed[i] = std::any_of(sides.begin(), sides.end(), reached);
    }
  }
  return needed;
}

DepthRange cube_range(glm::dvec4 light, const scene::Scene& scene, const MapContent& content) {
  const glm::dvec3 place = place_of(light);
  double near = 1e300, far = 0;
  for (const scene::Object& object : scene.objects) {
    if (object.casts()) near = std::min(near, distance_to(object, place));
  }
  for (const Polygon& side : content.receivers) {
    for (const glm::dvec3& corner : side) far = std::max(far, glm::length(corner - place));
  }
  if (!(far > 0)) far = 1;
  far *= 1.001;
  // A point at a distance d is at least d/√3 along the axis of its face.
  near = std::clamp(near * 0.999 / std::sqrt(3.0), far * 1e-5, far * 0.5);
  return {near, far};
}

}  // namespace shadowlab::shadow
