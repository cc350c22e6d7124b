#include "shadow/extrusion.h"

#include <algorithm>
#include <array>

#include "shadow/silhouette.h"

namespace shadowlab::shadow {
namespace {

using Index = std::uint32_t;

/// Appends the vertices and triangles of one triangle's part of the volume.
class Part {
 public:
  Part(DoubledMesh& mesh, const glm::vec4& face) : mesh_(mesh), face_(face) {}

  /// A cap a, b, c, or b, a, c where the triangle counts -1: the same two corners are exchanged as
  /// in `VolumeBuilder`'s caps, and for the same reason.
  void cap(glm::vec3 a, glm::vec3 b, glm::vec3 c, float w) {
    const Index first = next();
    vertex(a, b, w, glm::vec4(0));
    vertex(b, a, w, glm::vec4(0));
    vertex(c, c, w, glm::vec4(0));
    mesh_.indices.insert(mesh_.indices.end(), {first, first + 1, first + 2});
  }

  /// The side on the edge a→b of the triangle. The front cap runs along a→b, so the side runs b→a.
  void side(glm::vec3 a, glm::vec3 b, const glm::vec4& across) {
    const Index first = next();
    vertex(a, b, 1, across);
    vertex(b, a, 1, across);
    vertex(a, b, 0, across);
    vertex(b, a, 0, across);
    for (const Index corner : {1, 0, 2, 1, 2, 3}) mesh_.indices.push_back(first + corner);
  }

 private:
  Index next() const { return static_cast<Index>(mesh_.vertices.size()); }
  void vertex(glm::vec3 position, glm::vec3 turned, float w, const glm::vec4& across) {
    mesh_.vertices.push_back({glm::vec4(position, w), turned, face_, across});
  }

  DoubledMesh& mesh_;
  glm::vec4 face_;
};

}  // namespace

bool ExtrusionOrder::lit_faces_suffice(glm::dvec4 light) const {
  return std::all_of(boxes.begin(), boxes.end(), [&](const scene::Bounds& box) {
    Component component;
    component.low = box.low;
    component.high = box.high;
    component.closed = true;
    return component.lit_faces_suffice(light);
  });
}

ExtrusionOrder extrusion_order(const scene::Adjacency& adjacency) {
  const std::vector<Component> parts = components(adjacency);
  const auto plain = [&](Index t) {
    const Component& part = parts[adjacency.component[t]];
    return part.closed && !part.inside_out;
  };
  ExtrusionOrder order;
  order.triangles.resize(adjacency.triangles.size());
  for (Index t = 0; t < order.triangles.size(); ++t) order.triangles[t] = t;
  const auto middle = std::stable_partition(order.triangles.begin(), order.triangles.end(), plain);
  order.closed = static_cast<std::size_t>(middle - order.triangles.begin());
  for (const Component& part : parts) {
    if (part.closed && !part.inside_out) order.boxes.push_back({part.low, part.high});
  }
  return order;
}

DoubledMesh doubled_mesh(const scene::Adjacency& adjacency, const FacingPlanes& planes,
                         const ExtrusionOrder& order) {
  const auto next = scene::next(adjacency);
  DoubledMesh mesh;
  mesh.vertices.reserve(order.triangles.size() * DoubledMesh::vertices_a_triangle);
  mesh.indices.reserve(order.triangles.size() * DoubledMesh::indices_a_triangle);
  for (const Index t : order.triangles) {
    Part part(mesh, planes.plane(t));
    std::array<glm::vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = adjacency.positions[adjacency.triangles[t][k]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t across = next[t][k];
      part.side(corner[k], corner[(k + 1) % 3],
                across < 0 ? glm::vec4(0) : planes.plane(static_cast<std::size_t>(across)));
    }
    part.cap(corner[0], corner[1], corner[2], 1);
    part.cap(corner[0], corner[2], corner[1], 0);
  }
  return mesh;
}

DoubledMesh separate_faces(const scene::Adjacency& adjacency, const FacingPlanes& planes) {
  DoubledMesh mesh;
  for (std::size_t t = 0; t < adjacency.triangles.size(); ++t) {
    const auto& [a, b, c] = adjacency.triangles[t];
    Part(mesh, planes.plane(t))
        .cap(adjacency.positions[a], adjacency.positions[b], adjacency.positions[c], 1);
  }
  return mesh;
}

std::vector<std::uint32_t> ordered_with_adjacency(const scene::Adjacency& adjacency,
                                                  const ExtrusionOrder& order) {
  const std::vector<Index> indices = scene::indices_with_adjacency(adjacency);
  std::vector<Index> ordered;
  ordered.reserve(indices.size());
  for (const std::size_t t : order.triangles) {
    const auto first = indices.begin() + static_cast<std::ptrdiff_t>(6 * t);
    ordered.insert(ordered.end(), first, first + 6);
  }
  return ordered;
}

}  // namespace shadowlab::shadow
