// What a GPU needs to make shadow volumes by itself: vertices that never change, however the light
// moves. Each triangle brings its caps and a side on each of its edges; which of them are drawn,
// which way round, and which vertices are pushed away is decided where they are drawn.
//
// The chain is that of volume.h: a triangle counts c = +1, -1 or 0 by its facing; by rule 2 a
// triangle that faces away counts 0. Where an edge joins exactly two triangles of one orientation,
// with c and d, the side there stands c - d times: so each of the two throws its own side where c
// is not d, once for each, unless it counts 0 itself. At all other edges every triangle throws its
// own, and what cancels does so in the stencil. Both triangles must know c and d alike, to the bit,
// or the surface is torn: one reads the facing of the other from the same numbers.
//
// Sources: S. Brennan, Shadow Volume Extrusion Using a Vertex Shader, 2002 (degenerate quads);
// M. Stich, C. Wächter, A. Keller, Efficient and Robust Shadow Volumes Using Hierarchical Occlusion
// Culling and Geometry Shaders, 2007 (triangles with adjacency).
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "shadow/facing.h"
#include "shadow/volume.h"

namespace shadowlab::shadow {

/// A vertex of a doubled mesh, for shaders/extrude_vertex.vert.
struct ExtrudedVertex {
  glm::vec4 position;  ///< model space; w = 1: it stays, w = 0: it is pushed away from the light
  glm::vec3 turned;  ///< in its place where its triangle counts -1, which turns what it is part of
  glm::vec4 face;    ///< its triangle's plane, as `FacingPlanes::plane`
  glm::vec4 across;  ///< the plane across the edge whose side it is part of; 0 where there is none
};

/// Triangles that count by one rule of volume.h.
struct RuledRun {
  TriangleRange triangles;
  bool lit_faces_alone = false;  ///< rule 2
};
/// The runs of `run`, in order, as `VolumeBuilder::build` rules them for `light` (normalized, model
/// space).
std::vector<RuledRun> ruled_runs(const VolumeBuilder& builder, glm::dvec4 light,
                                 TriangleRange run = {});

/// The doubled mesh of a run of triangles: for each its sides and its caps, `indices_a_triangle`
/// that share no vertex with another's. What is outside the run is across no edge.
struct DoubledMesh {
  static constexpr std::size_t vertices_a_triangle = 18;
  static constexpr std::size_t indices_a_triangle = 24;
  std::vector<ExtrudedVertex> vertices;
  std::vector<std::uint32_t> indices;
};
DoubledMesh doubled_mesh(const FacingPlanes& planes, TriangleRange run = {});

/// The triangles alone, each with vertices of its own: what draws the sides turned from the light.
DoubledMesh separate_faces(const FacingPlanes& planes, TriangleRange run = {});

/// Six indices a triangle, as `scene::indices_with_adjacency` gives them, of a run, for
/// shaders/extrude_geometry.geom.
std::vector<std::uint32_t> run_with_adjacency(const FacingPlanes& planes, TriangleRange run = {});

}  // namespace shadowlab::shadow
