#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <numeric>

#include "shadow/crossings.h"
#include "shadow/differing.h"
#include "shadow/volume.h"

namespace shadowlab::shadow {
namespace {

using Index = std::uint32_t;

// Coefficients are read eight at a time, the first in the lowest byte.
constexpr std::size_t word_size = 8;
constexpr std::uint64_t ones = 0x0101010101010101u;
static_assert(std::endian::native == std::endian::little);

std::uint64_t word_at(const std::int8_t* coefficients) {
  std::uint64_t word = 0;
  std::memcpy(&word, coefficients, word_size);
  return word;
}

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
        parts[c].inside_out ? scene::Triangle{q, p, r} : scene::Triangle{p, q, r};
  }
  return out;
}

/// A side on a→b as often as `multiplicity` says, on b→a where that is negative; at least once. The
/// front cap runs along a→b, so the side runs b→a.
template <bool quads>
Index* append_side(Index* out, std::array<Index, 2> edge, int multiplicity) {
  // Two indices at a time, the first in the lower half. Of a vertex i the extruded one is i + 1.
  constexpr std::uint64_t first = 1, second = std::uint64_t{1} << 32;
  auto a_b = std::bit_cast<std::uint64_t>(edge);
  const std::uint64_t b_a = std::rotl(a_b, 32);
  const std::uint64_t run = multiplicity < 0 ? a_b : b_a;
  a_b = multiplicity < 0 ? b_a : a_b;
  int left = std::abs(multiplicity);
  do {
    // b, a, a + 1; and b, a + 1, b + 1.
    std::memcpy(out, &run, sizeof run);
    const std::uint64_t outer_a_b = a_b + first, outer = outer_a_b + second;
    std::memcpy(out + 2, &outer_a_b, sizeof run);
    if constexpr (quads) std::memcpy(out + 4, &outer, sizeof run);
    out += quads ? 6 : 3;
  } while (--left > 0);
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
    if (part.closed) closed_.push_back({{arrangement.begin[i], arrangement.begin[i + 1]}, part});
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
  const std::size_t count = arrangement.triangles.size();
  front_.resize(count + word_size);
  back_.resize(count + word_size);
  collect_edges(mesh, arrangement.place, arrangement.turned);
  std::size_t furthest = 0;
  for (const Run& run : runs_) furthest = std::max(furthest, run.stride);
  chain_.assign(count + furthest + differing_span, 0);
  planes_ = FacingPlanes(mesh.positions, std::move(arrangement.triangles));
  // A word more than can be found, and than the worst case of a side of six indices for each
  // triangle at each edge and two caps: some are written before it is known whether they stay.
  boundary_ = std::make_unique_for_overwrite<Index[]>(edge_triangles_.size() + word_size);
  indices_ = std::make_unique_for_overwrite<Index[]>(count * (3 * 6 + 6) + word_size);
}

void VolumeBuilder::collect_edges(const scene::Adjacency& mesh, std::span<const Index> place,
                                  std::span<const std::uint8_t> turned) {
  const auto missing = static_cast<Index>(place.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto around = mesh.at(e);
    const auto [a, b] = mesh.edges[e];
    // Turning a component round turns its edges' multiplicities: so turn the edges.
    const bool back = turned[around[0].triangle()] != 0;
    const std::array<Index, 2> ends = back ? std::array{2 * b, 2 * a} : std::array{2 * a, 2 * b};
    if (around.size() == 1 || (around.size() == 2 && around[1].sign() < 0)) {
      const Index t = place[around[0].triangle()];
      const Index u = around.size() == 1 ? missing : place[around[1].triangle()];
      // t < u: triangles of one component keep their order.
      edge_triangles_.push_back({t, u});
      edge_vertices_.push_back(ends);
      continue;
    }
    knot_vertices_.push_back(ends);
    knot_begin_.push_back(static_cast<Index>(knot_incidences_.size()));
    for (const scene::Incidence& i : around) {
      knot_incidences_.push_back({place[i.triangle()] * 2 + (i.sign() < 0 ? 1u : 0u)});
    }
  }
  knot_begin_.push_back(static_cast<Index>(knot_incidences_.size()));

  std::vector<std::size_t> strides;
  for (const auto& [t, u] : edge_triangles_) {
    if (u != missing) strides.push_back(u - t);
  }
  std::ranges::sort(strides);
  // Eight triangles are compared in the time that two edges are looked up.
  const std::size_t worth = place.size() / 4;
  for (auto at = strides.begin(); at != strides.end();) {
    const auto next = std::upper_bound(at, strides.end(), *at);
    if (static_cast<std::size_t>(next - at) > worth) take_run(*at);
    at = next;
  }
}

// The edges of one stride become a run; a second one between the same two triangles stays.
void VolumeBuilder::take_run(std::size_t stride) {
  const std::size_t count = front_.size() - word_size;
  Run run{stride, std::vector<std::int8_t>(count + differing_span, 0),
          std::vector<std::array<Index, 2>>(count)};
  std::size_t kept = 0;
  for (std::size_t e = 0; e < edge_triangles_.size(); ++e) {
    const auto [t, u] = edge_triangles_[e];
    if (u == t + stride && u < count && run.edges[t] == 0) {
      run.edges[t] = -1;
      run.vertices[t] = edge_vertices_[e];
    } else {
      edge_triangles_[kept] = edge_triangles_[e];
      edge_vertices_[kept++] = edge_vertices_[e];
    }
  }
  edge_triangles_.resize(kept);
  edge_vertices_.resize(kept);
  runs_.push_back(std::move(run));
}

std::span<const std::int8_t> VolumeBuilder::chain(glm::dvec4 light, Faces faces) {
  light = normalized_light(light);
  const std::span<std::int8_t> chain(chain_.data(), triangle_count());
  // Neighbours that are ruled alike are decided together.
  std::size_t begin = 0;
  bool lit = false;
  const auto decide_until = [&](std::size_t end) {
    const auto part = chain.subspan(begin, end - begin);
    lit ? planes_.lit(light, begin, part) : planes_.signs(light, begin, part);
    begin = end;
  };
  for (const auto& [triangles, component] : closed_) {
    const bool suffices = faces == Faces::automatic && component.lit_faces_suffice(light);
    if (suffices != lit) decide_until(triangles.first);
    lit = suffices;
  }
  const std::size_t closed_end = closed_.empty() ? 0 : closed_.back().triangles.last;
  if (lit) decide_until(closed_end);
  lit = false;
  decide_until(chain.size());
  return chain;
}

std::span<const std::uint32_t> VolumeBuilder::boundary_of_edges() {
  // Bytes may alias anything; these do not.
  const std::int8_t* __restrict const chain = chain_.data();
  const std::array<Index, 2>* __restrict const edges = edge_triangles_.data();
  Index* __restrict const boundary = boundary_.get();
  const std::size_t count = edge_triangles_.size();
  std::size_t found = 0;
#pragma GCC unroll 4
  for (std::size_t e = 0; e < count; ++e) {
    // Written whether it stays or not: a branch here would be mispredicted all along a silhouette.
    boundary[found] = static_cast<Index>(e);
    found += chain[edges[e][0]] != chain[edges[e][1]] ? 1 : 0;
  }
  return {boundary, found};
}

template <bool quads>
std::uint32_t* VolumeBuilder::append_sides(Index* out) {
  for (const Run& run : runs_) {
    const std::int8_t *const chain = chain_.data(), *const next = chain + run.stride;
    for (std::size_t first = 0; first < triangle_count(); first += differing_span) {
      std::uint64_t found = differing(chain + first, next + first, &run.edges[first]);
      for (; found != 0; found &= found - 1) {
        const std::size_t t = first + static_cast<std::size_t>(std::countr_zero(found));
        out = append_side<quads>(out, run.vertices[t], chain[t] - next[t]);
      }
    }
  }
  for (const Index e : boundary_of_edges()) {
    const auto& [t, u] = edge_triangles_[e];
    out = append_side<quads>(out, edge_vertices_[e], chain_[t] - chain_[u]);
  }
  for (std::size_t k = 0; k < knot_vertices_.size(); ++k) {
    int multiplicity = 0;
    for (Index i = knot_begin_[k]; i < knot_begin_[k + 1]; ++i) {
      multiplicity += knot_incidences_[i].sign() * chain_[knot_incidences_[i].triangle()];
    }
    if (multiplicity != 0) out = append_side<quads>(out, knot_vertices_[k], multiplicity);
  }
  return out;
}

std::uint32_t* VolumeBuilder::append_cap(Index* out, std::span<const scene::Triangle> cap) const {
  for (std::size_t first = 0; first < triangle_count(); first += word_size) {
    const std::uint64_t word = word_at(&chain_[first]);
    if (word == 0) continue;
    if (word == ones) {
      std::memcpy(out, &cap[first], word_size * sizeof(scene::Triangle));
      out += word_size * 3;
      continue;
    }
    for (std::size_t t = first; t < first + word_size; ++t) {
      // Written whether it stays or not, as in boundary_of_edges.
      const std::int8_t c = chain_[t];
      // Turned by its first two corners: rasterisers that sort a clockwise triangle by swapping
      // them, as Mesa's do, then compute the very depths of the surface that the cap covers.
      out[0] = cap[t][c < 0 ? 1 : 0];
      out[1] = cap[t][c < 0 ? 0 : 1];
      out[2] = cap[t][2];
      out += c != 0 ? 3 : 0;
    }
  }
  return out;
}

// The chain of those triangles that the options name.
void VolumeBuilder::count(glm::dvec4 light, const VolumeOptions& options) {
  const std::size_t count = chain(light, options.faces).size();
  std::fill_n(chain_.begin(), std::min(options.triangles.first, count), std::int8_t{0});
  for (std::size_t t = options.triangles.last; t < count; ++t) chain_[t] = 0;
}

Flat VolumeBuilder::flat(glm::dvec4 light, Filling filling, const VolumeOptions& options) {
  if (filling == Filling::none) return {{}, 0};
  light = normalized_light(light);
  count(light, options);
  Index* const begin = indices_.get();
  Index* end = begin;
  std::optional<std::size_t> layers;
  std::array<std::optional<int>, 3> of_faces;
  const auto rays_through = [&](Index* last) {
    std::array<std::optional<int>, 3> counts;
    for (int axis = 0; axis < 3; ++axis)
      counts[std::size_t(axis)] =
          crossings(vertices_, {begin, last}, glm::dvec3(light) / light.w, axis);
    return counts;
  };
  if (filling == Filling::around) of_faces = rays_through(append_cap(begin, front_));
  if (filling == Filling::faces) {
    end = append_cap(begin, front_);
  } else {
    // Each side begins b, a for an edge a→b.
    const Index* const sides_end = append_sides<false>(begin);
    outline_.clear();
    for (const Index* side = begin; side != sides_end; side += 3)
      outline_.push_back({side[1], side[0]});
    end = filling_.append(outline_, vertices_.size(), begin);
    if (filling == Filling::outline) layers = filling_.most_windings(vertices_, light);
  }
  int offset = 0;
  if (filling == Filling::around) {
    const auto of_outline = rays_through(end);
    std::size_t told = 0;
    while (told < 3 && !(of_faces[told] && of_outline[told])) ++told;
    if (told == 3) return flat(light, Filling::faces, options);
    // From the far end of the ray to the light it crosses as often the other way.
    offset = *of_outline[told] - *of_faces[told];
    // From one direction to another the count changes by how often the outline passes between them,
    // to one side more than to the other. As the light sees it an edge passes the great circle
    // through both at most once; as often as it passes between them it has to come back elsewhere.
    layers = static_cast<std::size_t>(std::abs(*of_faces[told])) + outline_.size() / 2;
  }
  if (options.handedness == Handedness::mirrored) {
    for (Index* i = begin; i != end; i += 3) std::swap(i[0], i[1]);
  }
  return {{begin, end}, layers, offset};
}

VolumeIndices VolumeBuilder::build(glm::dvec4 light, const VolumeOptions& options) {
  light = normalized_light(light);
  count(light, options);
  const bool one_point = light.w == 0 && options.reach == Reach::infinite;
  Index* const begin = indices_.get();
  Index* const front = one_point ? append_sides<false>(begin) : append_sides<true>(begin);
  const bool capped = options.caps == Caps::both;
  Index* const back = capped ? append_cap(front, front_) : front;
  Index* const end = capped && !one_point ? append_cap(back, back_) : back;
  if (options.handedness == Handedness::mirrored) {
    for (Index* i = begin; i != end; i += 3) std::swap(i[0], i[1]);
  }
  return {{begin, end}, {begin, front}, {front, back}, {back, end}};
}

}  // namespace shadowlab::shadow
