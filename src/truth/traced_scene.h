// What the tracer keeps of a scene, and its two questions: what is seen, and is it shadowed.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "truth/candidates.h"
#include "truth/crossing.h"

namespace shadowlab::truth {

/// A camera's rays, relative to the scene's centre; in pixels from the picture's top left corner.
struct View {
  View(const scene::Camera& camera, glm::dvec3 center, int width, int height);
  /// Of unit depth: eye + depth · direction(x, y) is seen at (x, y).
  glm::dvec3 direction(double x, double y) const;

  glm::dvec3 eye{0};
  double near = 0;
  double far = 0;

 private:
  glm::dvec3 top_left_, step_x_, step_y_;
};

/// The first surface along a ray.
struct Hit {
  const Triangle* triangle = nullptr;
  PlanePoint at;
  double depth = 0;
};

class TracedScene {
 public:
  explicit TracedScene(const scene::Scene& scene);

  /// Subtracted from the world's coordinates. A multiple of a power of two near the scene's size,
  /// so that the subtraction drops the shared leading digits and rounds as little as can be: zero
  /// for a scene around the origin.
  glm::dvec3 center() const { return center_; }
  std::size_t triangle_count() const { return all_.triangles().size(); }

  std::optional<Hit> first_hit(const View& view, double x, double y) const;

  /// A light or a light's point relative to the centre, w = 0 or 1. Throws InputError for other
  /// lights than (x, y, z, 0) and w > 0.
  glm::dvec4 relative(glm::dvec4 light) const;

  /// Whether a caster shadows `hit`, seen from `eye` (tracer.h says when). `last` is the caster
  /// that answered last, tried first: neighbours mostly share it. It changes the speed, never the
  /// answer.
  bool shadowed(const Hit& hit, glm::dvec3 eye, glm::dvec4 light, const Triangle*& last) const;

  /// Whether a caster blocks the open segment; both ends relative to the centre.
  bool blocked(glm::dvec3 from, glm::dvec4 light) const;

 private:
  const Candidates& casters() const { return casters_ ? *casters_ : all_; }

  glm::dvec3 center_{0};
  Candidates all_;
  std::optional<Candidates> casters_;  ///< absent where every object casts
};

}  // namespace shadowlab::truth
