#include "shadow/layers.h"

#include <vector>

#include "scene/exact_sign.h"

namespace shadowlab::shadow {
namespace {

// Deciding convexity compares every vertex with every face; larger components count as not convex.
constexpr std::size_t most_comparisons = 50'000'000;

bool is_convex(const scene::Adjacency& mesh, const std::vector<std::uint32_t>& triangles) {
  if (triangles.size() * triangles.size() > most_comparisons) return false;
  const auto corner = [&](std::uint32_t triangle, std::size_t k) {
    return mesh.positions[mesh.triangles[triangle][k]];
  };
  bool above = false, below = false;
  for (const std::uint32_t face : triangles) {
    for (const std::uint32_t other : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int side = scene::plane_side(corner(face, 0), corner(face, 1), corner(face, 2),
                                           glm::dvec4(corner(other, k), 1));
        above = above || side > 0;
        below = below || side < 0;
      }
    }
    if (above && below) return false;
  }
  return true;
}

}  // namespace

std::size_t layers(const scene::Adjacency& adjacency) {
  std::vector<std::vector<std::uint32_t>> parts(adjacency.closed.size());
  for (std::uint32_t i = 0; i < adjacency.triangles.size(); ++i)
    parts[adjacency.component[i]].push_back(i);
  std::size_t bound = 0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (!adjacency.closed[part]) {
      bound += parts[part].size();
    } else {
      bound += is_convex(adjacency, parts[part]) ? 1 : parts[part].size() / 2;
    }
  }
  return bound;
}

}  // namespace shadowlab::shadow
