// Which triangles a segment may meet: Embree's tree, asked so that float rounding never decides.
// (The only place that includes Embree.)
#pragma once

#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "truth/crossing.h"

namespace shadowlab::truth {

/// The points origin + t direction with low ≤ t ≤ high; high may be infinite.
struct Segment {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};
  double low = 0;
  double high = 1;
};

/// Triangles in a tree of boxes. Invariant: every triangle that a segment meets is proposed. A
/// float ray strays from its segment by at most 1.5 · 2^-24 of the largest coordinate R on each
/// axis: 2^-25 R as its origin is rounded, and 2^-25 of a step of at most 2 R as its direction is.
/// Boxes are grown by 2^-20 R, ten times that, and Embree's robust mode rounds its box tests
/// outward. (Segments are cut to the scene first, so that a far eye or light does not count.)
class Candidates {
 public:
  explicit Candidates(std::vector<Triangle> triangles);
  ~Candidates();
  Candidates(Candidates&&) noexcept;
  Candidates& operator=(Candidates&&) noexcept;

  const std::vector<Triangle>& triangles() const;

  /// Whether `accepts(triangle)` holds for a triangle that the segment may meet; stops at the
  /// first.
  template <typename Accepts>
  bool any(const Segment& segment, const Accepts& accepts) const {
    return any(segment, &accepts, [](const void* self, const Triangle& triangle) {
      return static_cast<bool>((*static_cast<const Accepts*>(self))(triangle));
    });
  }

  /// Calls `nearer(triangle)` for the triangles that the segment may meet, roughly from near to
  /// far. It returns the t up to which triangles are still of interest; that must never grow.
  template <typename Nearer>
  void visit(const Segment& segment, const Nearer& nearer) const {
    visit(segment, &nearer, [](const void* self, const Triangle& triangle) {
      return static_cast<double>((*static_cast<const Nearer*>(self))(triangle));
    });
  }

 private:
  using AcceptsCall = bool (*)(const void*, const Triangle&);
  using NearerCall = double (*)(const void*, const Triangle&);
  bool any(const Segment& segment, const void* self, AcceptsCall call) const;
  void visit(const Segment& segment, const void* self, NearerCall call) const;

  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace shadowlab::truth
