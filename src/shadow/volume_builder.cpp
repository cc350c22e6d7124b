#include <algorithm>
#include <cstring>
#include <numeric>

#include "shadow/volume.h"

namespace shadowlab::shadow {
namespace {

using Index = std::uint32_t;

constexpr std::size_t patch_size = 64;
constexpr std::int8_t mixed = 2;  // of a patch whose coefficients differ

/// Triangles in the builder's order, and what became of each of the adjacency's.
struct Arrangement {
  std::vector<scene::Triangle> triangles;
  std::vector<Index> place;          // of the adjacency's triangle
  std::vector<std::uint8_t> turned;  // whether it was turned round
  std::vector<std::size_t> begin;    // of each component, in `order`
  std::vector<Index> order;          // components, closed ones first
};

Arrangement arranged(const scene::Adjacency& mesh, const std::vector<Component>& parts) {
  Arrangement out;
  out.order.resize(parts.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  std::stable_partition(out.order.begin(), out.order.end(),
                        [&](Index c) { return parts[c].closed; });
  std::vector<std::size_t> size(parts.size(), 0), next(parts.size());
  for (const Index c : mesh.component) ++size[c];
  std::size_t begin = 0;
  for (const Index c : out.order) {
    out.begin.push_back(begin);
    next[c] = begin;
    begin += size[c];
  }
  out.begin.push_back(begin);
  out.triangles.resize(mesh.triangles.size());
  out.place.resize(mesh.triangles.size());
  out.turned.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Index c = mesh.component[t];
    const auto [p, q, r] = mesh.triangles[t];
    out.turned[t] = parts[c].inside_out ? 1 : 0;
    out.place[t] = static_cast<Index>(next[c]);
    out.triangles[next[c]++] =
        parts[c].inside_out ? scene::Triangle{p, r, q} : scene::Triangle{p, q, r};
  }
  return out;
}

/// A side on a→b. The front cap runs a→b, so the side runs b→a.
Index* append_side(Index* out, Index a, Index b, bool quad) {
  out[0] = b;
  out[1] = a;
  out[2] = a + 1;
  if (!quad) return out + 3;
  out[3] = b;
  out[4] = a + 1;
  out[5] = b + 1;
  return out + 6;
}

Index* append_sides_on(Index* out, std::array<Index, 2> edge, int multiplicity, bool quads) {
  const auto [a, b] = edge;
  for (; multiplicity > 0; --multiplicity) out = append_side(out, a, b, quads);
  for (; multiplicity < 0; ++multiplicity) out = append_side(out, b, a, quads);
  return out;
}

}  // namespace

VolumeBuilder::VolumeBuilder(const scene::Mesh& mesh, scene::Weld weld)
    : VolumeBuilder(scene::adjacency(mesh, weld)) {}

VolumeBuilder::VolumeBuilder(const scene::Adjacency& mesh) : planes_({}, {}) {
  const std::vector<Component> parts = components(mesh);
  Arrangement arrangement = arranged(mesh, parts);
  for (std::size_t i = 0; i < arrangement.order.size(); ++i) {
    const Component& part = parts[arrangement.order[i]];
    if (part.closed) closed_.push_back({arrangement.begin[i], arrangement.begin[i + 1], part});
  }
  vertices_.reserve(mesh.positions.size() * 2);
  for (const glm::vec3& p : mesh.positions) {
    vertices_.emplace_back(p, 1.0f);
    vertices_.emplace_back(p, 0.0f);
  }
  for (const auto& [a, b, c] : arrangement.triangles) {
    front_.push_back({2 * a, 2 * b, 2 * c});
    back_.push_back({2 * a + 1, 2 * c + 1, 2 * b + 1});
  }
  collect_edges(mesh, arrangement.place, arrangement.turned);
  const std::size_t count = arrangement.triangles.size();
  planes_ = FacingPlanes(mesh.positions, std::move(arrangement.triangles));
  chain_.assign(count + 1, 0);
  patches_.assign((count + patch_size - 1) / patch_size, 0);
  boundary_ = std::make_unique_for_overwrite<Index[]>(edge_triangles_.size() + 1);
  // At most a side for each triangle at each edge, of six indices, and two caps.
  indices_ = std::make_unique_for_overwrite<Index[]>(count * (3 * 6 + 6));
}

void VolumeBuilder::collect_edges(const scene::Adjacency& mesh, std::span<const Index> place,
                                  std::span<const std::uint8_t> turned) {
  struct Edge {
    std::array<Index, 2> triangles, vertices;
    std::size_t patch;
  };
  const auto missing = static_cast<Index>(place.size());
  const std::size_t patches = (place.size() + patch_size - 1) / patch_size;
  std::vector<Edge> edges;
  edges.reserve(mesh.edges.size());
  inner_.assign(patches + 2, 0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto around = mesh.at(e);
    const Index t = place[around[0].triangle()];
    const auto [a, b] = mesh.edges[e];
    // Turning a component round turns its edges' multiplicities: so turn the edges.
    const bool back = turned[around[0].triangle()] != 0;
    const std::array<Index, 2> ends = back ? std::array{2 * b, 2 * a} : std::array{2 * a, 2 * b};
    if (around.size() == 1 || (around.size() == 2 && around[1].sign() < 0)) {
      const Index u = around.size() == 1 ? missing : place[around[1].triangle()];
      const bool inside = u != missing && t / patch_size == u / patch_size;
      edges.push_back({{t, u}, ends, inside ? t / patch_size : patches});
      ++inner_[edges.back().patch + 1];
      continue;
    }
    knot_vertices_.push_back(ends);
    knot_begin_.push_back(static_cast<Index>(knot_incidences_.size()));
    for (const scene::Incidence& i : around) {
      knot_incidences_.push_back({place[i.triangle()] * 2 + (i.sign() < 0 ? 1u : 0u)});
    }
  }
  knot_begin_.push_back(static_cast<Index>(knot_incidences_.size()));
  std::partial_sum(inner_.begin(), inner_.end(), inner_.begin());
  edge_triangles_.resize(edges.size());
  edge_vertices_.resize(edges.size());
  std::vector<Index> next(inner_);
  for (const Edge& edge : edges) {
    const Index slot = next[edge.patch]++;
    edge_triangles_[slot] = edge.triangles;
    edge_vertices_[slot] = edge.vertices;
  }
}

void VolumeBuilder::fill_chain(glm::dvec4 light, Faces faces) {
  const std::span<std::int8_t> chain(chain_.data(), triangle_count());
  // Neighbours that are ruled alike are decided together.
  std::size_t begin = 0;
  bool lit = false;
  const auto decide_until = [&](std::size_t end) {
    const auto part = chain.subspan(begin, end - begin);
    lit ? planes_.lit(light, begin, part) : planes_.signs(light, begin, part);
    begin = end;
  };
  for (const ClosedRange& range : closed_) {
    const bool suffices = faces == Faces::automatic && range.component.lit_faces_suffice(light);
    if (suffices != lit) decide_until(range.first);
    lit = suffices;
  }
  const std::size_t closed_end = closed_.empty() ? 0 : closed_.back().last;
  if (lit) decide_until(closed_end);
  lit = false;
  decide_until(chain.size());
}

void VolumeBuilder::summarize_patches() {
  const std::size_t count = triangle_count();
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const std::int8_t* const begin = &chain_[p * patch_size];
    const std::size_t size = std::min(patch_size, count - p * patch_size);
    // All equal if each equals its neighbour.
    patches_[p] = std::memcmp(begin, begin + 1, size - 1) == 0 ? *begin : mixed;
  }
}

void VolumeBuilder::find_boundary(std::size_t first, std::size_t last) {
  const std::int8_t* const chain = chain_.data();
  Index* const boundary = boundary_.get();
  std::size_t found = found_;
  for (std::size_t e = first; e < last; ++e) {
    const auto& [t, u] = edge_triangles_[e];
    // Written whether it stays or not: a branch here would be mispredicted all along a silhouette.
    boundary[found] = static_cast<Index>(e);
    found += chain[t] != chain[u] ? 1 : 0;
  }
  found_ = found;
}

std::uint32_t* VolumeBuilder::append_sides(Index* out, bool quads) {
  found_ = 0;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    if (patches_[p] == mixed) find_boundary(inner_[p], inner_[p + 1]);
  }
  find_boundary(inner_[patches_.size()], edge_triangles_.size());
  for (std::size_t i = 0; i < found_; ++i) {
    const auto& [t, u] = edge_triangles_[boundary_[i]];
    out = append_sides_on(out, edge_vertices_[boundary_[i]], chain_[t] - chain_[u], quads);
  }
  for (std::size_t k = 0; k < knot_vertices_.size(); ++k) {
    int multiplicity = 0;
    for (Index i = knot_begin_[k]; i < knot_begin_[k + 1]; ++i) {
      multiplicity += knot_incidences_[i].sign() * chain_[knot_incidences_[i].triangle()];
    }
    out = append_sides_on(out, knot_vertices_[k], multiplicity, quads);
  }
  return out;
}

std::uint32_t* VolumeBuilder::append_cap(Index* out, std::span<const scene::Triangle> cap) const {
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    if (patches_[p] == 0) continue;
    const auto part =
        cap.subspan(p * patch_size).first(std::min(patch_size, cap.size() - p * patch_size));
    if (patches_[p] == 1) {
      std::memcpy(out, part.data(), part.size_bytes());
      out += part.size() * 3;
      continue;
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::int8_t c = chain_[p * patch_size + i];
      if (c == 0) continue;
      out[0] = part[i][0];
      out[1] = part[i][c > 0 ? 1 : 2];
      out[2] = part[i][c > 0 ? 2 : 1];
      out += 3;
    }
  }
  return out;
}

VolumeIndices VolumeBuilder::build(glm::dvec4 light, const VolumeOptions& options) {
  light = normalized_light(light);
  fill_chain(light, options.faces);
  summarize_patches();
  const bool one_point = light.w == 0 && options.reach == Reach::infinite;
  Index* const begin = indices_.get();
  Index* const front = append_sides(begin, !one_point);
  const bool capped = options.caps == Caps::both;
  Index* const back = capped ? append_cap(front, front_) : front;
  Index* const end = capped && !one_point ? append_cap(back, back_) : back;
  if (options.handedness == Handedness::mirrored) {
    for (Index* i = begin; i != end; i += 3) std::swap(i[1], i[2]);
  }
  return {{begin, end}, {begin, front}, {front, back}, {back, end}};
}

}  // namespace shadowlab::shadow
