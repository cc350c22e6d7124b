#include "live/dragging.h"

#include <cmath>
#include <limits>

namespace shadowlab::live {
namespace {

glm::dvec3 corner(const scene::Object& object, std::uint32_t index) {
  return glm::dvec3(object.model * glm::dvec4(glm::dvec3(object.mesh->positions[index]), 1));
}

// The distance along the ray to the triangle (Möller, Trumbore, Fast, Minimum Storage Ray/Triangle
// Intersection, 1997); infinity where it misses.
double distance_to(const Ray& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const glm::dvec3 ab = b - a, ac = c - a, across = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, across);
  if (determinant == 0) return never;
  const glm::dvec3 from = ray.origin - a;
  const double u = glm::dot(from, across) / determinant;
  const glm::dvec3 turned = glm::cross(from, ab);
  const double v = glm::dot(ray.direction, turned) / determinant;
  const double t = glm::dot(ac, turned) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : never;
}

double held_at(const scene::Camera& camera) {
  return 0.5 * glm::length(camera.eye - camera.target);
}

}  // namespace

glm::dvec3 light_handle(glm::dvec4 light, const scene::Camera& camera) {
  if (light.w != 0) return glm::dvec3(light) / light.w;
  return camera.target + glm::normalize(glm::dvec3(light)) * held_at(camera);
}

glm::dvec4 light_of_handle(glm::dvec3 handle, glm::dvec4 light, const scene::Camera& camera) {
  if (light.w != 0) return {handle, 1};
  const glm::dvec3 toward = handle - camera.target;
  const double length = glm::length(toward);
  return length > 0 ? glm::dvec4(toward / length, 0) : light;
}

std::optional<Hit> first_caster(const scene::Scene& scene, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> object;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& candidate = scene.objects[i];
    const auto& indices = candidate.mesh->indices;
    for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
      const double distance =
          distance_to(ray, corner(candidate, indices[t]), corner(candidate, indices[t + 1]),
                      corner(candidate, indices[t + 2]));
      if (distance < nearest) {
        nearest = distance;
        object = i;
      }
    }
  }
  if (!object || !scene.objects[*object].casts()) return {};
  return Hit{*object, ray.origin + ray.direction * nearest};
}

std::optional<glm::dvec3> on_plane(const Ray& ray, glm::dvec3 point, glm::dvec3 normal) {
  const double along = glm::dot(ray.direction, normal);
  if (std::abs(along) < 1e-6) return {};
  const double distance = glm::dot(point - ray.origin, normal) / along;
  if (distance <= 0) return {};
  return ray.origin + ray.direction * distance;
}

}  // namespace shadowlab::live
