// Which vertices are one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace shadowlab::scene {

/// How near two vertices must be to be one, metres in model space. 0 joins equal positions only
/// (-0 = +0), and then no vertex moves.
struct Weld {
  double tolerance = 0.0;
};

struct WeldedVertices {
  std::vector<glm::vec3> positions;      ///< each position once, in order of first appearance
  std::vector<std::uint32_t> vertex_of;  ///< given vertex to index into `positions`
};

/// With a tolerance, each vertex joins the earliest kept one within it, else it is kept itself: the
/// answer depends on the order, and no vertex moves farther than the tolerance. Throws InputError
/// for a tolerance that is negative, not finite, or less than 2^-40 of the largest coordinate.
WeldedVertices weld(std::span<const glm::vec3> positions, Weld weld);

}  // namespace shadowlab::scene
