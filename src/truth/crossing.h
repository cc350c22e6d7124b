// The decisions of the tracer: where a line meets a triangle, and on which side of it a point lies.
// All coordinates are doubles relative to the scene's centre.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

namespace shadowlab::truth {

struct Triangle {
  glm::dvec3 a, b, c;
  std::uint32_t object = 0;
  std::uint32_t index = 0;
};

/// The determinant |b-a c-a p-a| for p = (x, y, z, 1), or |b-a c-a p| for a direction (x, y, z, 0):
/// positive on the side from which a, b, c turn counter-clockwise. Zero only if it is exactly zero,
/// and of the right sign: a filtered double, then the exact sum (Shewchuk 1997, expansions). Exact
/// as long as no product of three coordinates overflows or underflows.
double side(const Triangle& triangle, glm::dvec4 p);

/// A point of a triangle's plane, and by how much rounding may have moved each coordinate off it.
struct PlanePoint {
  glm::dvec3 point{0};
  glm::dvec3 rounding{0};
};

/// Whether `p` is on the plane of `triangle` as far as its rounding tells; `height` is side(p).
bool on_plane(const Triangle& triangle, const PlanePoint& p, double height);

/// A line through `origin` along `direction` (not zero), prepared for many triangles: the shear of
/// Woop, Benthin and Wald 2013 that turns the line into the z axis.
class Line {
 public:
  Line(glm::dvec3 origin, glm::dvec3 direction);

  /// Twice the signed areas of the triangles that the line's point makes with the edges, as seen
  /// along the line: barycentric coordinates up to their sum.
  struct Crossing {
    double u, v, w;
  };

  /// Whether the line meets the closed triangle. A line in the triangle's plane does not.
  ///
  /// Invariant: the projection of a vertex depends on the line and the vertex alone, and the sign
  /// of an edge function on its two projections alone, opposite for the two directions of the edge.
  /// So of two triangles at an edge at least one is met where their union is.
  std::optional<Crossing> crossing(const Triangle& triangle) const;

  /// The parameter of the crossing: origin + t direction.
  double parameter(const Triangle& triangle, const Crossing& crossing) const;

 private:
  glm::dvec2 projected(glm::dvec3 vertex) const;

  glm::dvec3 origin_;
  int x_, y_, z_;  ///< z_ is the longest axis of the direction
  double shear_x_, shear_y_, scale_z_;
};

/// The point of `triangle` with those coordinates.
PlanePoint point_at(const Triangle& triangle, const Line::Crossing& crossing);

}  // namespace shadowlab::truth
