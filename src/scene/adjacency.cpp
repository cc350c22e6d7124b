#include "scene/adjacency.h"

#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "scene/exact_sign.h"

namespace shadowlab::scene {
namespace {

/// A triangle's k-th edge runs from corner k to corner k + 1; its number is 3 * triangle + k.
struct HalfEdge {
  std::uint32_t high;  // the greater of its two vertices; the lesser one is the bucket's
  std::uint32_t number;
  bool operator<(const HalfEdge& other) const {
    return high != other.high ? high < other.high : number < other.number;
  }
};

std::uint32_t corner_after(const Triangle& triangle, std::uint32_t k) {
  return triangle[k == 2 ? 0 : k + 1];
}

void keep_triangles_with_area(const Mesh& mesh, Adjacency& out) {
  const std::size_t count = mesh.triangle_count();
  out.triangles.reserve(count);
  out.source.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = out.vertex_of[mesh.indices[3 * t + k]];
    const auto [a, b, c] = triangle;
    if (collinear(out.positions[a], out.positions[b], out.positions[c])) continue;
    out.triangles.push_back(triangle);
    out.source.push_back(static_cast<std::uint32_t>(t));
  }
}

/// All half-edges, by lesser vertex (`begin`, a bucket a vertex), then greater, then number.
std::vector<HalfEdge> sorted_half_edges(const Adjacency& mesh, std::vector<std::uint32_t>& begin) {
  begin.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      ++begin[std::min(triangle[k], corner_after(triangle, k)) + 1];
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<HalfEdge> half_edges(mesh.triangles.size() * 3);
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  std::uint32_t number = 0;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::uint32_t k = 0; k < 3; ++k, ++number) {
      const auto [low, high] = std::minmax({triangle[k], corner_after(triangle, k)});
      half_edges[end[low]++] = {high, number};
    }
  }
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(half_edges.begin() + begin[v], half_edges.begin() + begin[v + 1]);
  }
  return half_edges;
}

/// Where in `half_edges` each undirected edge's run begins, in order of the run's first triangle.
std::vector<std::uint32_t> runs_by_first_triangle(const std::vector<HalfEdge>& half_edges,
                                                  const std::vector<std::uint32_t>& begin,
                                                  std::size_t triangles) {
  std::vector<std::uint32_t> runs;
  runs.reserve(half_edges.size() / 2 + 1);
  std::vector<std::uint32_t> slot(triangles + 1, 0);
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      if (i > begin[v] && half_edges[i].high == half_edges[i - 1].high) continue;
      runs.push_back(i);
      ++slot[half_edges[i].number / 3 + 1];
    }
  }
  std::partial_sum(slot.begin(), slot.end(), slot.begin());
  std::vector<std::uint32_t> ordered(runs.size());
  for (const std::uint32_t run : runs) ordered[slot[half_edges[run].number / 3]++] = run;
  return ordered;
}

void collect_edges(Adjacency& out) {
  std::vector<std::uint32_t> bucket;
  const std::vector<HalfEdge> half_edges = sorted_half_edges(out, bucket);
  const std::vector<std::uint32_t> runs =
      runs_by_first_triangle(half_edges, bucket, out.triangles.size());
  out.edges.reserve(runs.size());
  out.begin.reserve(runs.size() + 1);
  out.incidences.reserve(half_edges.size());
  for (const std::uint32_t run : runs) {
    const auto corner = [&](const HalfEdge& h) {
      return out.triangles[h.number / 3][h.number % 3];
    };
    const HalfEdge& first = half_edges[run];
    const std::uint32_t a = corner(first);
    const std::uint32_t b = corner_after(out.triangles[first.number / 3], first.number % 3);
    out.edges.push_back({a, b});
    out.begin.push_back(static_cast<std::uint32_t>(out.incidences.size()));
    const std::uint32_t bucket_end = bucket[std::min(a, b) + 1];
    for (std::uint32_t i = run; i < bucket_end && half_edges[i].high == first.high; ++i) {
      const std::uint32_t reversed = corner(half_edges[i]) == a ? 0 : 1;
      out.incidences.push_back({half_edges[i].number / 3 * 2 + reversed});
    }
  }
  out.begin.push_back(static_cast<std::uint32_t>(out.incidences.size()));
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t t) {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

void find_components(Adjacency& out) {
  std::vector<std::uint32_t>& parent = out.component;
  parent.resize(out.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  std::vector<std::uint8_t> bounded(out.triangles.size(), 0);  // has an edge of the boundary
  for (std::size_t e = 0; e < out.edges.size(); ++e) {
    const auto around = out.at(e);
    std::uint32_t p = root_of(parent, around[0].triangle());
    int multiplicity = around[0].sign();
    for (const Incidence& incidence : around.subspan(1)) {
      const std::uint32_t q = root_of(parent, incidence.triangle());
      // The lesser one is the root, so components come in order of their first triangle.
      parent[std::max(p, q)] = std::min(p, q);
      p = std::min(p, q);
      multiplicity += incidence.sign();
    }
    if (multiplicity != 0) bounded[around[0].triangle()] = 1;
  }
  // A root's own entry turns into its component's number when its turn comes, before all others'.
  for (std::uint32_t t = 0; t < parent.size(); ++t) {
    if (parent[t] == t) {
      parent[t] = static_cast<std::uint32_t>(out.closed.size());
      out.closed.push_back(1);
    } else {
      // Parents are lesser, so theirs is a number already.
      parent[t] = parent[parent[t]];
    }
    if (bounded[t] != 0) out.closed[parent[t]] = 0;
  }
}

/// Calls found(triangle, k, across, across_k) for both half-edges of each edge that joins exactly
/// two triangles of one orientation.
template <class Found>
void for_each_joint(const Adjacency& mesh, Found found) {
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto around = mesh.at(e);
    if (around.size() != 2 || around[0].sign() + around[1].sign() != 0) continue;
    const std::uint32_t t = around[0].triangle(), across = around[1].triangle();
    const auto side = [&](std::uint32_t triangle, std::uint32_t from) {
      const Triangle& corners = mesh.triangles[triangle];
      return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), from) -
                                      corners.begin());
    };
    const std::size_t k = side(t, mesh.edges[e][0]), across_k = side(across, mesh.edges[e][1]);
    found(t, k, across, across_k);
    found(across, across_k, t, k);
  }
}

}  // namespace

Adjacency adjacency(const Mesh& mesh, Weld weld) {
  if (mesh.triangle_count() > (std::size_t{1} << 30)) {
    throw InputError("The mesh has more than 2^30 triangles; use a smaller one.");
  }
  check(mesh);
  Adjacency out;
  WeldedVertices welded = scene::weld(mesh.positions, weld);
  out.positions = std::move(welded.positions);
  out.vertex_of = std::move(welded.vertex_of);
  keep_triangles_with_area(mesh, out);
  collect_edges(out);
  find_components(out);
  return out;
}

std::vector<std::array<std::int32_t, 3>> next(const Adjacency& adjacency) {
  std::vector<std::array<std::int32_t, 3>> next(adjacency.triangles.size(), {-1, -1, -1});
  for_each_joint(adjacency, [&](std::uint32_t t, std::size_t k, std::uint32_t across, std::size_t) {
    next[t][k] = static_cast<std::int32_t>(across);
  });
  return next;
}

std::vector<std::uint32_t> indices_with_adjacency(const Adjacency& adjacency) {
  std::vector<std::uint32_t> indices(adjacency.triangles.size() * 6);
  for (std::size_t t = 0; t < adjacency.triangles.size(); ++t) {
    const Triangle& corners = adjacency.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      indices[6 * t + 2 * k] = corners[k];
      indices[6 * t + 2 * k + 1] = corners[(k + 2) % 3];
    }
  }
  for_each_joint(
      adjacency, [&](std::uint32_t t, std::size_t k, std::uint32_t across, std::size_t across_k) {
        indices[6 * std::size_t{t} + 2 * k + 1] = adjacency.triangles[across][(across_k + 2) % 3];
      });
  return indices;
}

}  // namespace shadowlab::scene
