#include "shadow/extrusion.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace shadowlab::shadow {
namespace {

using Index = std::uint32_t;

/// Appends the vertices and triangles of one triangle's part of the volume.
class ExtrudedPart {
 public:
  ExtrudedPart(DoubledMesh& mesh, const glm::vec4& face) : mesh_(mesh), face_(face) {}

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

TriangleRange within(const FacingPlanes& planes, TriangleRange run) {
  return {run.first, std::min(run.last, planes.triangles().size())};
}

struct HalfEdge {
  std::array<Index, 2> ends;  // the lesser first
  std::size_t number;         // 3 * triangle + k, triangles counted from the run's first
  bool operator<(const HalfEdge& other) const {
    return std::tie(ends, number) < std::tie(other.ends, other.number);
  }
};

/// For each half-edge the one across it, where the edge joins exactly two triangles of the run and
/// of one orientation; else itself.
std::vector<std::size_t> across(const FacingPlanes& planes, TriangleRange run) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * run.count());
  const auto from = [&](std::size_t number) {
    return planes.triangles()[run.first + number / 3][number % 3];
  };
  for (std::size_t i = 0; i < 3 * run.count(); ++i) {
    const auto [low, high] = std::minmax({from(i), from(i % 3 == 2 ? i - 2 : i + 1)});
    edges.push_back({{low, high}, i});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::size_t> found(edges.size());
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next].ends == edges[i].ends) ++next;
    for (std::size_t k = i; k < next; ++k) found[edges[k].number] = edges[k].number;
    if (next - i != 2 || from(edges[i].number) == from(edges[i + 1].number)) continue;
    found[edges[i].number] = edges[i + 1].number;
    found[edges[i + 1].number] = edges[i].number;
  }
  return found;
}

std::array<glm::vec3, 3> corners_of(const FacingPlanes& planes, std::size_t triangle) {
  const auto& [a, b, c] = planes.triangles()[triangle];
  return {planes.positions()[a], planes.positions()[b], planes.positions()[c]};
}

}  // namespace

std::vector<RuledRun> ruled_runs(const VolumeBuilder& builder, glm::dvec4 light,
                                 TriangleRange run) {
  run = within(builder.facing(), run);
  std::vector<RuledRun> runs;
  const auto append = [&](TriangleRange triangles, bool lit_faces_alone) {
    triangles.first = std::max(triangles.first, run.first);
    triangles.last = std::min(triangles.last, run.last);
    if (triangles.first >= triangles.last) return;
    if (!runs.empty() && runs.back().lit_faces_alone == lit_faces_alone) {
      runs.back().triangles.last = triangles.last;
    } else {
      runs.push_back({triangles, lit_faces_alone});
    }
  };
  std::size_t closed_end = 0;
  for (const auto& closed : builder.closed_components()) {
    append(closed.triangles, closed.component.lit_faces_suffice(light));
    closed_end = closed.triangles.last;
  }
  append({closed_end, run.last}, false);
  return runs;
}

DoubledMesh doubled_mesh(const FacingPlanes& planes, TriangleRange run) {
  run = within(planes, run);
  const auto neighbours = across(planes, run);
  DoubledMesh mesh;
  mesh.vertices.reserve(run.count() * DoubledMesh::vertices_a_triangle);
  mesh.indices.reserve(run.count() * DoubledMesh::indices_a_triangle);
  for (std::size_t t = 0; t < run.count(); ++t) {
    const auto [a, b, c] = corners_of(planes, run.first + t);
    ExtrudedPart part(mesh, planes.plane(run.first + t));
    const auto plane_across = [&](std::size_t k) {
      const std::size_t other = neighbours[3 * t + k] / 3;
      return other == t ? glm::vec4(0) : planes.plane(run.first + other);
    };
    part.side(a, b, plane_across(0));
    part.side(b, c, plane_across(1));
    part.side(c, a, plane_across(2));
    part.cap(a, b, c, 1);
    part.cap(a, c, b, 0);
  }
  return mesh;
}

DoubledMesh separate_faces(const FacingPlanes& planes, TriangleRange run) {
  run = within(planes, run);
  DoubledMesh mesh;
  for (std::size_t t = run.first; t < run.last; ++t) {
    const auto [a, b, c] = corners_of(planes, t);
    ExtrudedPart(mesh, planes.plane(t)).cap(a, b, c, 1);
  }
  return mesh;
}

std::vector<std::uint32_t> run_with_adjacency(const FacingPlanes& planes, TriangleRange run) {
  run = within(planes, run);
  const auto neighbours = across(planes, run);
  std::vector<Index> indices;
  indices.reserve(6 * run.count());
  // The corner that is not on the half-edge. Of a triangle that is its own neighbour, its own.
  const auto opposite = [&](std::size_t number) {
    return planes.triangles()[run.first + number / 3][(number % 3 + 2) % 3];
  };
  for (std::size_t i = 0; i < 3 * run.count(); ++i) {
    indices.push_back(planes.triangles()[run.first + i / 3][i % 3]);
    indices.push_back(opposite(neighbours[i]));
  }
  return indices;
}

}  // namespace shadowlab::shadow
