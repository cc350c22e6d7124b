#include "shadow/volume.h"

#include "core/error.h"

namespace shadowlab::shadow {

glm::dvec4 extruded(glm::dvec3 p, glm::dvec4 light, double distance) {
  const glm::dvec3 away = p * light.w - glm::dvec3(light);
  if (distance == infinite) return {away, 0};
  const double length = glm::length(away);
  return {length > 0 ? p + away * (distance / length) : p, 1};
}

VolumeMesh volume(const scene::Adjacency& adjacency, glm::dvec4 light, Caps caps, double distance) {
  if (!(distance > 0)) {
    throw InputError("The distance to extrude a shadow volume to must be more than 0.");
  }
  light = normalized_light(light);
  VolumeBuilder builder(adjacency);
  const Reach reach = distance == infinite ? Reach::infinite : Reach::finite;
  const VolumeIndices built = builder.build(light, {.caps = caps, .reach = reach});
  VolumeMesh mesh;
  mesh.positions.reserve(builder.vertices().size());
  for (const glm::vec4& v : builder.vertices()) {
    const glm::dvec3 p(v);
    mesh.positions.push_back(v.w != 0 ? glm::dvec4(p, 1) : extruded(p, light, distance));
  }
  mesh.indices.assign(built.all.begin(), built.all.end());
  mesh.side_indices = built.sides.size();
  return mesh;
}

}  // namespace shadowlab::shadow
