// What the tests ask of a mesh's surface, its vertices being one where their positions are.
#pragma once

#include <array>
#include <map>
#include <utility>

#include "scene/mesh.h"

namespace shadowlab::scene {

using Position = std::array<float, 3>;

inline Position key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

/// For each edge a → b, the number of triangles that run along it that way less the other way.
inline std::map<std::pair<Position, Position>, int> signed_edges(const Mesh& mesh) {
  std::map<std::pair<Position, Position>, int> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Position a = key(mesh.positions[mesh.indices[3 * t + i]]);
      const Position b = key(mesh.positions[mesh.indices[3 * t + (i + 1) % 3]]);
      if (a < b) ++edges[{a, b}];
      if (b < a) --edges[{b, a}];
    }
  }
  return edges;
}

/// The number of edges along which the triangles do not cancel: 0 for a closed mesh.
inline int open_edges(const Mesh& mesh) {
  int open = 0;
  for (const auto& [edge, count] : signed_edges(mesh)) open += count != 0;
  return open;
}

inline glm::dvec3 area_vector(const Mesh& mesh, std::size_t t) {
  const glm::dvec3 a = mesh.positions[mesh.indices[3 * t]];
  const glm::dvec3 b = mesh.positions[mesh.indices[3 * t + 1]];
  const glm::dvec3 c = mesh.positions[mesh.indices[3 * t + 2]];
  return 0.5 * glm::cross(b - a, c - a);
}

inline double area(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) sum += glm::length(area_vector(mesh, t));
  return sum;
}

/// Positive where a closed mesh's triangles are counter-clockwise seen from outside.
inline double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    sum += glm::dot(glm::dvec3(mesh.positions[mesh.indices[3 * t]]), area_vector(mesh, t)) / 3.0;
  }
  return sum;
}

inline int degenerate_triangles(const Mesh& mesh) {
  int count = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    count += glm::length(area_vector(mesh, t)) == 0.0;
  }
  return count;
}

/// The least cosine between a triangle and the normals at its corners.
inline double least_normal_agreement(const Mesh& mesh) {
  double least = 1.0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::dvec3 facing = glm::normalize(area_vector(mesh, i / 3));
    least = std::min(least, glm::dot(facing, glm::dvec3(mesh.normals[mesh.indices[i]])));
  }
  return least;
}

}  // namespace shadowlab::scene
