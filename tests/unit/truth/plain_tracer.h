// A second tracer, as plain as can be: every triangle, long double, world coordinates, a small
// distance where the other one reasons. It shares no code with src/truth.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::truth {

class PlainTracer {
 public:
  using Real = long double;
  using Vector = glm::tvec3<Real>;

  explicit PlainTracer(const scene::Scene& scene) {
    for (const scene::Object& object : scene.objects) {
      for (std::size_t t = 0; t < object.mesh->triangle_count(); ++t) {
        Face face{{}, object.casts()};
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::vec3 p = object.mesh->positions[object.mesh->indices[3 * t + k]];
          face.corner[k] = Vector(object.model * glm::dvec4(p, 1));
        }
        faces_.push_back(face);
      }
    }
  }

  /// 0 or 1 at the first surface through the pixel's centre; 1 where there is none.
  int visible(const scene::Camera& camera, glm::dvec4 light, int width, int height, int x,
              int y) const {
    const glm::dmat4 to_clip =
        camera.projection(static_cast<double>(width) / height) * camera.view();
    const glm::dmat4 to_world = glm::inverse(to_clip);
    const double u = 2 * (x + 0.5) / width - 1, v = 1 - 2 * (y + 0.5) / height;
    const glm::dvec4 near = to_world * glm::dvec4(u, v, -1, 1);
    const glm::dvec4 far = to_world * glm::dvec4(u, v, 1, 1);
    const Vector from(glm::dvec3(near) / near.w), to(glm::dvec3(far) / far.w);
    Real nearest = 1;
    const Face* seen = nullptr;
    for (const Face& face : faces_) {
      const auto t = crossing(face, from, to - from);
      if (t && *t >= 0 && *t <= nearest) nearest = *t, seen = &face;
    }
    if (seen == nullptr) return 1;
    const Vector point = from + nearest * (to - from);
    return lit(*seen, point, Vector(camera.eye), light);
  }

 private:
  struct Face {
    Vector corner[3];
    bool casts;
  };

  static Vector normal(const Face& f) {
    return glm::normalize(glm::cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]));
  }

  int lit(const Face& own, Vector point, Vector eye, glm::dvec4 light) const {
    const bool point_light = light.w != 0;
    const Vector target(glm::dvec3(light) / (point_light ? light.w : 1));
    const Vector toward = point_light ? target - point : target;
    if (own.casts && glm::dot(normal(own), eye - point) * glm::dot(normal(own), toward) < 0)
      return 0;
    for (const Face& face : faces_) {
      if (!face.casts) continue;
      if (std::abs(glm::dot(normal(face), point - face.corner[0])) < 1e-9L) continue;
      const auto t = crossing(face, point, toward);
      if (t && *t > 0 && (!point_light || *t < 1)) return 0;
    }
    return 1;
  }

  // Möller and Trumbore 1997.
  static std::optional<Real> crossing(const Face& face, Vector origin, Vector direction) {
    const Vector ab = face.corner[1] - face.corner[0], ac = face.corner[2] - face.corner[0];
    const Vector p = glm::cross(direction, ac);
    const Real determinant = glm::dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const Vector from = origin - face.corner[0];
    const Real u = glm::dot(from, p) / determinant;
    const Vector q = glm::cross(from, ab);
    const Real v = glm::dot(direction, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    return glm::dot(ac, q) / determinant;
  }

  std::vector<Face> faces_;
};

}  // namespace shadowlab::truth
