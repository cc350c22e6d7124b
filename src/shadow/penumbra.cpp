#include "shadow/penumbra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "scene/adjacency.h"
#include "shadow/facing.h"
#include "shadow/reach.h"
#include "shadow/silhouette.h"

namespace shadowlab::shadow {
namespace {

/// A parallelogram center ± u ± v, and its plane's unit normal.
struct Face {
  glm::dvec3 center, u, v, normal;

  bool holds(glm::dvec3 point) const {
    const glm::dvec3 off = point - center;
    const auto within = [&](glm::dvec3 axis, glm::dvec3 other) {
      const glm::dvec3 across = glm::cross(other, normal);
      return std::abs(glm::dot(off, across)) <= std::abs(glm::dot(axis, across)) * (1 + 1e-9);
    };
    return within(u, v) && within(v, u);
  }
  /// Where the ray from `from` through `through` meets the plane beyond it.
  std::optional<glm::dvec3> shadow(glm::dvec3 from, glm::dvec3 through) const {
    const double toward = glm::dot(normal, through - from);
    if (toward == 0) return {};
    const double along = glm::dot(normal, center - from) / toward;
    if (!(along > 1)) return {};
    return from + along * (through - from);
  }
};

std::vector<Face> faces_of(const scene::Object& object) {
  const scene::Bounds bounds = scene::bounds(*object.mesh);
  if (bounds.empty()) return {};
  const Crate crate = crate_around(bounds, object.model, 0);
  const auto face = [&](std::size_t k, double side) {
    const glm::dvec3 u = crate.half[(k + 1) % 3], v = crate.half[(k + 2) % 3];
    return Face{crate.center + side * crate.half[k], u, v, glm::normalize(glm::cross(u, v))};
  };
  std::size_t thinnest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (glm::length(crate.half[k]) < glm::length(crate.half[thinnest])) thinnest = k;
  }
  if (scene::plane_of(*object.mesh, object.model)) return {face(thinnest, 0)};
  std::vector<Face> faces;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double side : {-1.0, 1.0}) faces.push_back(face(k, side));
  }
  return faces;
}

class Picture {
 public:
  Picture(const scene::Camera& camera, glm::ivec2 size)
      : view_(camera.view()),
        size_(size),
        slope_(std::tan(glm::radians(camera.fovy) / 2)),
        near_(camera.near) {}

  double area() const { return size_.x * size_.y; }
  /// Nothing for what is before the near plane.
  std::optional<glm::dvec2> pixel(glm::dvec3 point) const {
    const glm::dvec4 p = view_ * glm::dvec4(point, 1);
    if (!(-p.z >= near_)) return {};
    const double scale = size_.y / (2 * slope_ * -p.z);
    return glm::dvec2(p.x, p.y) * scale + size_ * 0.5;
  }
  bool holds(glm::dvec2 p) const { return p.x >= 0 && p.y >= 0 && p.x < size_.x && p.y < size_.y; }

 private:
  glm::dmat4 view_;
  glm::dvec2 size_;
  double slope_, near_;
};

/// From the light's centre to its point farthest along a unit vector.
glm::dvec3 farthest_along(const scene::Light& light, glm::dvec3 n) {
  using Shape = scene::Light::Shape;
  const double u = glm::dot(light.half_u, n), v = glm::dot(light.half_v, n);
  switch (light.shape) {
    case Shape::sphere:
      return light.radius * n;
    case Shape::rectangle:
      return std::copysign(1.0, u) * light.half_u + std::copysign(1.0, v) * light.half_v;
    case Shape::disk: {
      const double length = std::sqrt(u * u + v * v);
      if (length > 0) return (u * light.half_u + v * light.half_v) / length;
      break;
    }
    case Shape::point:
      break;
  }
  return glm::dvec3(0);
}

/// What an edge's shadow sweeps on a face, as it is seen: across it and along it, in pixels.
std::optional<glm::dvec2> strip(const Picture& picture, const Face& face, glm::dvec3 center,
                                const scene::Light& light, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 middle = (a + b) * 0.5, along = glm::cross(b - a, middle - center);
  const double length = glm::length(along);
  if (!(length > 0)) return {};
  const glm::dvec3 reach = farthest_along(light, along / length);
  const auto at = face.shadow(center, middle);
  if (!at || !face.holds(*at)) return {};
  const auto seen = picture.pixel(*at);
  if (!seen || !picture.holds(*seen)) return {};
  std::array<glm::dvec2, 4> corners;
  const std::array rays{std::pair{center, a}, std::pair{center, b},
                        std::pair{center + reach, middle}, std::pair{center - reach, middle}};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto point = face.shadow(rays[i].first, rays[i].second);
    const auto pixel = point ? picture.pixel(*point) : std::nullopt;
    if (!pixel) return {};
    corners[i] = *pixel;
  }
  const glm::dvec2 edge = corners[1] - corners[0], sweep = corners[3] - corners[2];
  const double edge_length = glm::length(edge);
  if (!(edge_length > 0)) return {};
  return glm::dvec2(std::abs(edge.x * sweep.y - edge.y * sweep.x) / edge_length, edge_length);
}

}  // namespace

Penumbra penumbra(const scene::Scene& scene, const scene::Camera& camera, const scene::Light& light,
                  glm::ivec2 picture_size) {
  if (light.shape == scene::Light::Shape::point || !(light.position.w > 0)) return {};
  const Picture picture(camera, picture_size);
  const glm::dvec3 center = glm::dvec3(light.position) / light.position.w;
  double length = 0, area = 0;
  for (const scene::Object& caster : scene.objects) {
    if (!caster.casts()) continue;
    const scene::Adjacency mesh = scene::adjacency(*caster.mesh);
    const auto edges = silhouette(mesh, light_in_model_space(caster.model, light.position));
    for (const scene::Object& receiver : scene.objects) {
      if (!receiver.receives() || &receiver == &caster) continue;
      for (const Face& face : faces_of(receiver)) {
        for (const SilhouetteEdge& edge : edges) {
          const auto place = [&](std::uint32_t i) {
            return glm::dvec3(caster.model * glm::dvec4(mesh.positions[i], 1));
          };
          const auto swept = strip(picture, face, center, light, place(edge.a), place(edge.b));
          if (!swept) continue;
          length += swept->y;
          area += swept->x * swept->y;
        }
      }
    }
  }
  Penumbra found;
  if (length > 0) found.width = area / length;
  found.pixels = std::min(area, picture.area());
  found.share = found.pixels / picture.area();
  return found;
}

double expected_error(const Penumbra& penumbra, int points) {
  return std::sqrt(penumbra.share) * 0.3 * std::pow(points, -0.75);
}

int points_for(const Penumbra& penumbra, double error) {
  int points = 1;
  while (points < 65536 && expected_error(penumbra, points) > error) points *= 2;
  return points;
}

double error_of_halves(double difference) { return difference / 2; }

}  // namespace shadowlab::shadow
