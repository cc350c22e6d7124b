// How often a caster's volume can hold one point: what the bits of a stencil have room for.
//
// Seen from the light, the count at the far end of each ray is the number of counted triangles that
// it meets. It changes only across the silhouette, by the edge's multiplicity: so in a cell of what
// the light sees it is at most the count along one ray plus the edges that reach into the cell, and
// at most the triangles that do. Cells are quartered until that is little. Where it stays too much,
// since it is, or since too much meets at one vertex, the triangles are halved: any run of them has
// a volume of its own, and the volumes of the runs add up to the whole one, as chains are added
// (see volume.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "shadow/volume.h"

namespace shadowlab::shadow {

/// Some of a builder's triangles, of which no ray from the light meets more than `layers`.
struct Part {
  TriangleRange triangles;
  std::size_t layers = 0;
};

class Layers {
 public:
  /// Of `builder`, which must outlive it.
  explicit Layers(VolumeBuilder& builder);

  /// The parts in which the volume for `light` (as VolumeBuilder::build takes it) must be drawn so
  /// that none holds a point more than `most` ≥ 2 times; in order, all triangles together. One for
  /// most casters. Kept until the light moves; allocates nothing once its vectors have grown.
  std::span<const Part> parts(glm::dvec4 light, std::size_t most = 127);

 private:
  using Index = std::uint32_t;
  struct Window {
    glm::dvec2 low, high;
  };
  /// A part of what the light sees: what reaches into it, in the vectors below, and a bound.
  struct Cell {
    Window window;
    std::size_t triangles, edges;  ///< where its own begin
    std::size_t triangles_end, edges_end;
    std::size_t layers;
    int depth;
  };
  /// What a finer bound would gain nothing by: a stencil has room for many such casters.
  std::size_t enough() const { return most_ / 16; }
  void split(TriangleRange range);
  std::size_t bound(TriangleRange range);
  void look_into(const Window& window, const Cell& all);
  std::size_t quartered();
  std::size_t weight(std::span<const Index> triangles) const;
  /// How many triangles a ray meets, for certain and up to rounding.
  struct Met {
    std::size_t least = 0, most = 0;
  };
  Met met_along(glm::dvec2 direction, std::span<const Index> triangles) const;
  bool reaches_into(std::span<const Index> vertices, const Window& window) const;
  glm::dmat3 toward_middle() const;
  void look_along(const glm::dmat3& frame);
  std::optional<Window> around(std::span<const Index> triangles) const;

  VolumeBuilder& builder_;
  /// Of each triangle in a convex component, which; triangles of the others have none.
  std::vector<Index> convex_;
  std::vector<std::uint8_t> crossed_twice_;  ///< of each convex component, for the light
  glm::dvec4 light_{0};
  std::size_t most_ = 0;
  std::vector<Part> parts_;
  std::vector<std::int8_t> chain_;
  glm::dmat3 toward_middle_{1};
  // Vertices as the light sees them along a frame: (x, y, w), at x/w, y/w, with a bound of the
  // error.
  std::optional<glm::dmat3> frame_;
  std::vector<glm::dvec4> seen_;
  std::vector<Index> triangles_;
  std::vector<std::array<Index, 2>> edges_;
  std::vector<Cell> cells_;  ///< a heap: the one with the most layers first
  bool too_many_ = false;    ///< a ray meets more than most_
  std::size_t tests_left_ = 0;
};

}  // namespace shadowlab::shadow
