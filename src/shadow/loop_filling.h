// Closed loops of directed edges, filled by triangles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// Triangles whose boundary is a given cycle: edges of which as many enter each vertex as leave it.
/// The edges are walked into loops. A loop of n vertices becomes n - 2 triangles: each second
/// vertex is cut off by one, then each second of those that are left, and so on; so that all of
/// them together are about as long as the loop times log2 n, where a fan from one vertex is n times
/// as long as the loop is wide. What they cost a rasteriser is their length: they are slivers.
class LoopFilling {
 public:
  using Edge = std::array<std::uint32_t, 2>;  ///< from, to

  /// Triangles at `out`, which has room for one an edge; returns their end. The boundary of their
  /// sum is the sum of the edges. No vertex is `vertices` or more.
  std::uint32_t* append(std::span<const Edge> edges, std::size_t vertices, std::uint32_t* out);

  /// No point is wound round more often than this by the loops of the last `append` as a light
  /// sees them: a loop crosses the line through a point in a given direction, to the other side
  /// each time, twice for each time that it winds round it; so it has as many maxima along the
  /// line's normal. The least of four directions. `light` is normalized; nothing where a vertex is
  /// not before the light, as one sees it that looks at the middle of the loops' box.
  std::optional<std::size_t> most_windings(std::span<const glm::vec4> vertices, glm::dvec4 light);

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::vector<std::uint32_t> leaving_;  // vertex to an edge that leaves it and is not walked yet
  std::vector<std::uint32_t> next_;     // edge to another one from its vertex
  std::vector<std::uint32_t> loops_;    // one after the other
  std::vector<std::size_t> ends_;       // of each
  std::vector<std::uint32_t> loop_;     // what is left of one
  std::vector<glm::dvec2> seen_;        // of each in loops_
};

}  // namespace shadowlab::shadow
