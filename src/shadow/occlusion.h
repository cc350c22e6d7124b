// What boxes hide from the camera: a coarse picture of depths behind which nothing is seen.
#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// Where something is seen, and from what depth on.
struct Extent {
  glm::dvec2 low{+1e300}, high{-1e300};  ///< pixels
  double nearest = 1e300;                ///< depth along the view
  bool empty() const { return low.x > high.x; }
  void add(glm::dvec2 pixel, double depth) {
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
    nearest = depth < nearest ? depth : nearest;
  }
  void add(const Extent& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
    nearest = other.nearest < nearest ? other.nearest : nearest;
  }
  bool holds(const Extent& other) const {
    return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x &&
           high.y >= other.high.y;
  }
};

/// Cells of one or more pixels, each with a depth at which an occluder covers all of it. An
/// occluder counts where it covers a cell and a pixel around it, and by its farthest visible point:
/// so what is called hidden is. Occlusion maps: H. Zhang et al., Visibility Culling using
/// Hierarchical Occlusion Maps, 1997, with one level.
class Occlusion {
 public:
  explicit Occlusion(glm::ivec2 picture);

  /// A convex body, its corners' pixels and depths (all before the near plane), of which no visible
  /// point is deeper than `farthest`.
  void add(const std::array<glm::dvec2, 8>& corners, double farthest);

  /// Whether all of `extent`, a pixel around it too, is behind occluders.
  bool hides(const Extent& extent) const;

 private:
  glm::ivec2 picture_;
  int cell_;  ///< pixels
  glm::ivec2 cells_;
  std::vector<float> depths_;  ///< infinite where nothing covers
};

}  // namespace shadowlab::shadow
