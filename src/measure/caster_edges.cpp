#include "measure/caster_edges.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace shadowlab::measure {
namespace {

struct Before {
  bool operator()(glm::dvec3 a, glm::dvec3 b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
  bool operator()(const std::pair<glm::dvec3, glm::dvec3>& a,
                  const std::pair<glm::dvec3, glm::dvec3>& b) const {
    return (*this)(a.first, b.first) || (!(*this)(b.first, a.first) && (*this)(a.second, b.second));
  }
};

std::pair<glm::dvec3, glm::dvec3> sorted(glm::dvec3 a, glm::dvec3 b) {
  return Before()(b, a) ? std::pair(b, a) : std::pair(a, b);
}

// On which side of the plane through the edge and the light a triangle's third corner is.
double side_of(glm::dvec3 third, const Edge& edge, glm::dvec4 light) {
  return glm::dot(glm::cross(edge.b - edge.a, glm::dvec3(light) - light.w * edge.a),
                  third - edge.a);
}

}  // namespace

std::vector<Edge> caster_edges(const scene::Scene& scene, glm::dvec4 light) {
  struct Triangles {
    std::vector<glm::dvec3> thirds;
    std::size_t forward = 0;  // that run along the edge from its lesser corner
  };
  std::map<std::pair<glm::dvec3, glm::dvec3>, Triangles, Before> found;
  for (const scene::Object& object : scene.objects) {
    if (!object.casts()) continue;
    const scene::Mesh& mesh = *object.mesh;
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(object.model * glm::dvec4(mesh.positions[mesh.indices[i]], 1));
    };
    for (std::size_t t = 0; t < 3 * mesh.triangle_count(); t += 3) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = corner(t + i), b = corner(t + (i + 1) % 3);
        Triangles& triangles = found[sorted(a, b)];
        triangles.thirds.push_back(corner(t + (i + 2) % 3));
        triangles.forward += Before()(a, b);
      }
    }
  }
  std::vector<Edge> edges;
  edges.reserve(found.size());
  for (const auto& [ends, triangles] : found) {
    Edge edge{ends.first, ends.second, triangles.thirds.size()};
    if (edge.sides == 2 && triangles.forward == 1) {
      const auto& thirds = triangles.thirds;
      edge.sides = side_of(thirds[0], edge, light) * side_of(thirds[1], edge, light) >= 0 ? 1 : 0;
    }
    edges.push_back(edge);
  }
  return edges;
}

glm::dvec2 nearest(const Edge& p, const Edge& q) {
  const glm::dvec3 d1 = p.b - p.a, d2 = q.b - q.a, r = p.a - q.a;
  const double a = glm::dot(d1, d1), e = glm::dot(d2, d2), f = glm::dot(d2, r);
  if (a == 0 || e == 0) return {0, e == 0 ? 0 : std::clamp(f / e, 0.0, 1.0)};
  const double c = glm::dot(d1, r), b = glm::dot(d1, d2), denominator = a * e - b * b;
  double s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0;
  double t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace shadowlab::measure
