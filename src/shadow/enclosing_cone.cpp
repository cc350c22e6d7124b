#include "shadow/enclosing_cone.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace shadowlab::shadow {

double angle(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Cone enclosing_cone(glm::dvec3 eye, std::span<const glm::dvec3> points) {
  Cone cone;
  std::vector<glm::dvec3> directions;
  glm::dvec3 sum(0);
  for (const glm::dvec3& point : points) {
    const glm::dvec3 along = point - eye;
    const double length = glm::length(along);
    if (!(length > 0)) return {cone.axis, std::numbers::pi};
    directions.push_back(along / length);
    sum += directions.back();
  }
  if (directions.empty()) return cone;
  glm::dvec3 center = sum / static_cast<double>(directions.size());
  for (int i = 1; i <= 64; ++i) {
    const glm::dvec3* farthest = &directions[0];
    for (const glm::dvec3& direction : directions) {
      if (glm::dot(direction, center) < glm::dot(*farthest, center)) farthest = &direction;
    }
    center += (*farthest - center) / static_cast<double>(i + 1);
  }
  if (glm::length(center) < 1e-9) return {cone.axis, std::numbers::pi};
  cone.axis = glm::normalize(center);
  for (const glm::dvec3& direction : directions)
    cone.half_angle = std::max(cone.half_angle, angle(cone.axis, direction));
  return cone;
}

}  // namespace shadowlab::shadow
