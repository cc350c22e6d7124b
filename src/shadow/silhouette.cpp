#include "shadow/silhouette.h"

#include "scene/exact_sign.h"
#include "shadow/facing.h"

namespace shadowlab::shadow {

bool Component::lit_faces_suffice(glm::dvec4 light) const {
  if (!closed) return false;
  if (light.w == 0) return true;
  for (int i = 0; i < 3; ++i) {
    // Rounding is monotonic, so a light inside the box never passes for outside.
    if (light[i] < light.w * low[i] || light[i] > light.w * high[i]) return true;
  }
  return false;
}

std::vector<Component> components(const scene::Adjacency& adjacency) {
  std::vector<Component> components(adjacency.closed.size());
  std::vector<double> volume(components.size(), 0.0);
  for (std::size_t t = 0; t < adjacency.triangles.size(); ++t) {
    const std::uint32_t c = adjacency.component[t];
    const auto corner = [&](std::size_t k) {
      return glm::dvec3(adjacency.positions[adjacency.triangles[t][k]]);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      components[c].low = glm::min(components[c].low, corner(k));
      components[c].high = glm::max(components[c].high, corner(k));
    }
    // About a point of the component's own, so that a far origin does not drown the volume.
    const glm::dvec3 origin = components[c].low;
    volume[c] += glm::dot(corner(0) - origin, glm::cross(corner(1) - origin, corner(2) - origin));
  }
  for (std::size_t c = 0; c < components.size(); ++c) {
    components[c].closed = adjacency.closed[c] != 0;
    components[c].inside_out = components[c].closed && volume[c] < 0;
  }
  return components;
}

std::vector<std::int8_t> shadow_chain(const scene::Adjacency& adjacency, glm::dvec4 light) {
  light = normalized_light(light);
  const std::vector<Component> parts = components(adjacency);
  std::vector<std::int8_t> chain(adjacency.triangles.size());
  for (std::size_t t = 0; t < chain.size(); ++t) {
    const auto& [a, b, c] = adjacency.triangles[t];
    const int facing = scene::plane_side(adjacency.positions[a], adjacency.positions[b],
                                         adjacency.positions[c], light);
    const Component& part = parts[adjacency.component[t]];
    const int counted = part.inside_out ? -1 : +1;
    const bool counts = facing == counted || !part.lit_faces_suffice(light);
    chain[t] = static_cast<std::int8_t>(counts ? facing : 0);
  }
  return chain;
}

std::vector<SilhouetteEdge> boundary(const scene::Adjacency& adjacency,
                                     std::span<const std::int8_t> chain) {
  std::vector<SilhouetteEdge> edges;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    int multiplicity = 0;
    for (const scene::Incidence& incidence : adjacency.at(e)) {
      multiplicity += incidence.sign() * chain[incidence.triangle()];
    }
    const auto [a, b] = adjacency.edges[e];
    if (multiplicity > 0) edges.push_back({a, b, static_cast<std::uint32_t>(multiplicity)});
    if (multiplicity < 0) edges.push_back({b, a, static_cast<std::uint32_t>(-multiplicity)});
  }
  return edges;
}

std::vector<SilhouetteEdge> silhouette(const scene::Adjacency& adjacency, glm::dvec4 light) {
  return boundary(adjacency, shadow_chain(adjacency, light));
}

}  // namespace shadowlab::shadow
