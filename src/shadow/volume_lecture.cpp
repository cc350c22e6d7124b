#include "shadow/volume_lecture.h"

#include "core/error.h"
#include "scene/exact_sign.h"

namespace shadowlab::shadow {

VolumeMesh volume_lecture(const scene::Adjacency& adjacency,
                          std::span<const std::array<std::int32_t, 3>> next, glm::dvec4 light,
                          Edges edges, double distance) {
  if (!(distance > 0)) {
    throw InputError("The distance to extrude a shadow volume to must be more than 0.");
  }
  light = normalized_light(light);
  const auto& triangles = adjacency.triangles;
  std::vector<bool> lit(triangles.size());
  for (std::size_t face = 0; face < triangles.size(); ++face) {
    const auto& [a, b, c] = triangles[face];
    lit[face] = scene::plane_side(adjacency.positions[a], adjacency.positions[b],
                                  adjacency.positions[c], light) > 0;
  }
  VolumeMesh volume;
  for (const glm::vec3& p : adjacency.positions) {
    volume.positions.emplace_back(p, 1);
    volume.positions.push_back(extruded(p, light, distance));
  }
  for (std::size_t face = 0; face < triangles.size(); ++face) {
    if (edges != Edges::all && !lit[face]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t across = next[face][k];
      if (edges == Edges::silhouette && across >= 0 && lit[static_cast<std::size_t>(across)]) {
        continue;
      }
      const std::uint32_t a = 2 * triangles[face][k], b = 2 * triangles[face][(k + 1) % 3];
      for (const std::uint32_t i : {b, a, a + 1, b, a + 1, b + 1}) volume.indices.push_back(i);
    }
  }
  volume.side_indices = volume.indices.size();
  return volume;
}

}  // namespace shadowlab::shadow
