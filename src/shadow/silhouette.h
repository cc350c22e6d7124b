// The silhouette: the boundary of the chain of triangles that cast the shadow.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/adjacency.h"

namespace shadowlab::shadow {

/// A side of the volume stands on the edge a→b `multiplicity` ≥ 1 times.
struct SilhouetteEdge {
  std::uint32_t a = 0;  ///< welded vertices
  std::uint32_t b = 0;
  std::uint32_t multiplicity = 1;
};

/// What the rules of volume.h ask of a connected component.
struct Component {
  glm::dvec3 low{+1e300};  ///< its box
  glm::dvec3 high{-1e300};
  bool closed = false;
  bool inside_out = false;  ///< closed, and its signed volume is negative

  /// Whether its facing triangles alone cast its whole shadow: it is closed and `light`
  /// (normalized, model space) is outside its box.
  bool lit_faces_suffice(glm::dvec4 light) const;
};

/// One for each component of `adjacency`.
std::vector<Component> components(const scene::Adjacency& adjacency);

/// How often, and which way round, each triangle counts in the caster's chain for `light` (model
/// space), by the rules of volume.h: +1 where it faces the light, -1 where it faces away, 0 where
/// the light is in its plane; but of a closed component with the light outside its box only those
/// that face the light count, or, where the component is inside out, only those that face away. So
/// the volume holds a point as often as that point's segment to the light crosses a counted
/// triangle.
std::vector<std::int8_t> shadow_chain(const scene::Adjacency& adjacency, glm::dvec4 light);

/// The edges where the boundary of `chain` (a coefficient for each triangle) is not zero, turned so
/// that the multiplicity is positive. For a closed oriented mesh and its lit faces: closed loops.
std::vector<SilhouetteEdge> boundary(const scene::Adjacency& adjacency,
                                     std::span<const std::int8_t> chain);

/// The silhouette of the mesh from `light` (model space): boundary(shadow_chain).
std::vector<SilhouetteEdge> silhouette(const scene::Adjacency& adjacency, glm::dvec4 light);

}  // namespace shadowlab::shadow
