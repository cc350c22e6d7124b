// The exact truth: what a camera sees, and which of it a light reaches.
//
// What is exact. Positions are the mesh's floats under the object's model matrix, applied in double
// relative to the scene's centre (so a world a million units away loses nothing). Embree (robust
// mode) only proposes triangles, from boxes grown by more than its float rounding; each yes or no
// is taken in double, with an exact sign where double is in doubt (truth/crossing.h).
//
// Watertight. Each ray projects every vertex to one point, whatever triangle asks, and then decides
// edges by exact signs; a point on an edge belongs to both sides. So no ray slips between triangles
// that share an edge or a vertex.
//
// No offset against self-shadowing. A surface point P, seen from the eye E, is known only up to the
// rounding ε of its own coordinates (a few units in the last place). For each caster's triangle, P
// is on its front, on its back, or, when its distance to the plane is under ε, on the plane.
//   - Not on the plane: the triangle shadows P if the open segment from P to the light crosses it.
//   - On the plane: a segment that starts on a plane never meets it again, so the triangle cannot
//     shadow P from elsewhere. This covers P's own triangle, coplanar ones, and those that share
//     the edge or vertex that P is on. What remains is which side of the sheet is seen: P stands
//     for the limit of points that approach it from E, so the sheet shadows P if it contains P and
//     E and the light are on opposite sides of it. Thus the unlit side of a sheet is in shadow, and
//     for a closed caster this says of a face turned from the light what the rest of its mesh says
//     anyway.
// Nothing is moved, so a contact leaks no light: a point 1e-12 from a wall's foot is still on the
// right side of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "image/image.h"
#include "scene/scene.h"
#include "shadow/samples.h"

namespace shadowlab::truth {

/// What the ray through a pixel's centre meets first.
struct Surface {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t object = none;    ///< index into Scene::objects; `none`: background
  std::uint32_t triangle = none;  ///< triangle of that object's mesh
  glm::dvec3 point{0};            ///< world space
  double depth = 0;               ///< distance along the view direction, metres, in [near, far]
  glm::dvec3 normal{0};  ///< world space, unit; the side the triangle winds counter-clockwise

  bool hit() const { return object != none; }
};

/// Rows from the top, as FloatImage has them.
struct SurfaceImage {
  int width = 0;
  int height = 0;
  std::vector<Surface> surfaces;
  const Surface& at(int x, int y) const {
    return surfaces[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)];
  }
};

/// Which points of an area light are tried. Point lights and lights at infinity need one ray.
struct Sampling {
  /// Points a pixel; where `error` is given, the most points a pixel.
  int samples = 256;
  shadow::Pattern pattern = shadow::Pattern::owen;
  std::uint64_t seed = 0;
  /// Absent: the same `samples` points of `pattern` for every pixel, which is what a recipe that
  /// accumulates hard shadows over shadow::samples(light, samples, pattern, seed) must give.
  /// Present: adaptive. Each pixel has its own Owen-scrambled Sobol sequence, doubled until the
  /// estimated standard error of its mean is at most `error`.
  std::optional<double> error = std::nullopt;
};

/// Visibility, and what it cost.
struct SoftTruth {
  image::FloatImage visibility;
  std::uint64_t rays = 0;       ///< shadow rays spent
  std::size_t unconverged = 0;  ///< pixels that reached the most samples with more error than asked
};

/// One scene, ready to be traced. Keeps copies of what it needs; may be shared between threads.
class Tracer {
 public:
  /// Throws InputError for meshes that break their invariants, MachineError where Embree cannot
  /// start.
  explicit Tracer(const scene::Scene& scene);
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// The first surface through each pixel's centre (x+1/2, y+1/2) between the near and the far
  /// plane; all objects, both sides of each triangle. On equal depth the lowest (object, triangle).
  SurfaceImage surfaces(const scene::Camera& camera, int width, int height) const;

  /// The visibility of `light` at those surfaces, in [0, 1]; 1 where there is no surface. Casters
  /// (roles caster and both) shadow; receivers alone do not. The same bits for any `threads`
  /// (0: as many as the machine has).
  image::FloatImage visibility(const scene::Camera& camera, const scene::Light& light, int width,
                               int height, const Sampling& sampling = {}, int threads = 0) const;

  /// The same, with its cost.
  SoftTruth soft_visibility(const scene::Camera& camera, const scene::Light& light, int width,
                            int height, const Sampling& sampling = {}, int threads = 0) const;

  /// Pixels where a rasteriser may rightly differ: those that have, within one pixel (the square of
  /// side 2 around the pixel's centre), an edge of `light`'s hard shadow or an edge between two
  /// visible sheets. Found on the lattice of `per_pixel` points a pixel and axis that contains all
  /// pixel centres: a pixel is marked when two lattice points in its square differ in visibility,
  /// or two neighbouring ones lie on different sheets (different objects, or triangles of one
  /// object whose depths differ by more than the slopes of both explain). The terminator of a
  /// faceted closed caster is a shadow edge too. What is narrower than the lattice may be missed;
  /// four more points around each centre catch what a rasteriser's snapping could bring over it. 1
  /// where marked, 0 elsewhere. Area lights: the edges of
  /// their centre's hard shadow.
  image::FloatImage edge_mask(const scene::Camera& camera, const scene::Light& light, int width,
                              int height, int per_pixel = 4, int threads = 0) const;

  /// Whether a caster blocks the open segment between two points of the world, or from `from`
  /// toward `light` at infinity (w = 0). Triangles whose plane contains an end do not block.
  bool blocked(glm::dvec3 from, glm::dvec4 light) const;

  std::size_t triangle_count() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace shadowlab::truth
