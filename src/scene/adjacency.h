// The edge graph of a triangle soup: what silhouettes and volumes are read from.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/mesh.h"
#include "scene/weld.h"

namespace shadowlab::scene {

using Triangle = std::array<std::uint32_t, 3>;

/// One triangle at an edge, and which way it runs along it.
struct Incidence {
  std::uint32_t code = 0;  ///< triangle * 2 + (1 where it runs b to a)
  std::uint32_t triangle() const { return code >> 1; }
  int sign() const { return (code & 1) != 0 ? -1 : +1; }
};

/// Any soup, open, non-manifold, wrongly oriented or with duplicates, as a simplicial complex. The
/// boundary of a chain (an integer coefficient c for each triangle) is, at each edge a→b, the
/// signed multiplicity: the sum of sign·c over the edge's incidences. Triangles without area are
/// dropped (they cover nothing and cast nothing).
struct Adjacency {
  std::vector<glm::vec3> positions;      ///< welded vertices, model space
  std::vector<std::uint32_t> vertex_of;  ///< mesh vertex to welded vertex
  std::vector<Triangle> triangles;       ///< those with an area, of welded vertices
  std::vector<std::uint32_t> source;     ///< triangle to the mesh's triangle
  std::vector<std::array<std::uint32_t, 2>>
      edges;                             ///< each undirected edge once, in the direction
                                         ///< of its first triangle, in order of that triangle
  std::vector<std::uint32_t> begin;      ///< edge to its first incidence; edges.size() + 1 long
  std::vector<Incidence> incidences;     ///< at each edge by ascending triangle, so first is +1
  std::vector<std::uint32_t> component;  ///< triangle to connected component (through edges)
  std::vector<std::uint8_t> closed;      ///< component: 1 where its triangles have no boundary

  std::span<const Incidence> at(std::size_t edge) const {
    return std::span(incidences).subspan(begin[edge], begin[edge + 1] - begin[edge]);
  }
};

/// Throws InputError as `check(mesh)` and for more than 2^30 triangles. Linear time
/// for meshes of bounded valence, n log n for any.
Adjacency adjacency(const Mesh& mesh, Weld weld = {});

/// The lecture's `next`: the triangle across each edge (0→1, 1→2, 2→0) of each of
/// `adjacency.triangles`, -1 where the edge does not join exactly two triangles of one orientation.
std::vector<std::array<std::int32_t, 3>> next(const Adjacency& adjacency);

/// Six indices a triangle for GL_TRIANGLES_ADJACENCY (v0, opposite 01, v1, opposite 12, v2,
/// opposite 20) into `adjacency.positions`; across an edge without one neighbour the triangle's own
/// third vertex stands in, which makes the neighbour this triangle turned round.
std::vector<std::uint32_t> indices_with_adjacency(const Adjacency& adjacency);

}  // namespace shadowlab::scene
