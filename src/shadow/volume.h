// Shadow volumes: where the light does not reach.
//
// The volume of one triangle T turned toward the light L (counter-clockwise as L sees it) is every
// point p whose segment to L crosses T. Its surface: T itself (front cap), T at infinity or at a
// distance, reversed (back cap), and a side on each edge. Volumes add as chains: with a coefficient
// c for each triangle as given, and s its facing (+1, -1, 0), the volume of the chain Σ c·T holds p
// exactly Σ c·s times, over the triangles that the segment from p to L crosses; its sides stand on
// the chain's boundary. A point is in shadow where that number is not zero, so c·s must never be
// negative.
//
// Rule 1, any soup: c = s. Then c·s = 1 for each crossed triangle, whatever the orientation, the
// holes or the duplicates: p is held as often as there are triangles between it and L. Right
// always. Rule 2, a closed component (its boundary is zero) with L outside its box: c = 1 where s =
// +1, else 0, half the caps and half the sides. Let W be the component's winding number. W(L) = 0,
// and along the segment from p to L each lit triangle lowers W by one, each unlit one raises it by
// one: so lit - unlit = W(p). Where W(p) ≥ 0 any crossing at all implies a lit one: right. A
// component turned inside out (signed volume < 0) is turned round first, so W ≥ 0 everywhere unless
// the component crosses itself into an inside-out pocket. Points in such a pocket are walled in by
// the component on all sides; who must be right even there forces rule 1 by `Faces::turned`. Both:
// whatever the integers c, the surface is closed, so z-fail counts are right for every c; a facing
// of zero (the light in the plane) gives c = 0, so nothing is drawn on such a triangle's edge but
// its neighbours' sides.
//
// Sources: F. Crow, Shadow Algorithms for Computer Graphics, 1977; P. Bergeron, A General Version
// of Crow's Shadow Volumes, 1986 (open meshes); C. Everitt, M. Kilgard, Practical and Robust
// Stenciled Shadow Volumes, 2002 (w = 0); B. Kim, K. Kim, G. Turk, A Shadow-Volume Algorithm for
// Opaque and Transparent Nonmanifold Casters, 2008 (signed multiplicity).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/adjacency.h"
#include "shadow/facing.h"
#include "shadow/loop_filling.h"
#include "shadow/outline.h"
#include "shadow/silhouette.h"

namespace shadowlab::shadow {

enum class Caps { none, both };
/// infinite: w = 0, all that a directional light extrudes is one point, so its sides are triangles
/// and there is no back cap. finite: extruded vertices stay apart.
enum class Reach { infinite, finite };
/// Which triangles count: the rules above, or rule 1 for all.
enum class Faces { automatic, turned };
/// Whether the model matrix that the volume is drawn with mirrors (its determinant is negative):
/// the triangles are then turned, so that they are counter-clockwise from outside after it.
enum class Handedness { kept, mirrored };

/// Triangles [first, last) in a builder's order.
struct TriangleRange {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  std::size_t count() const { return last - first; }
};

struct VolumeOptions {
  Caps caps = Caps::both;
  Reach reach = Reach::infinite;
  Faces faces = Faces::automatic;
  Handedness handedness = Handedness::kept;
  TriangleRange triangles{};  ///< those that count: the volumes of parts add up to the whole one
};

/// Triangles, counter-clockwise seen from outside the volume, as indices into
/// `VolumeBuilder::vertices()`. Valid until the builder's next `build`.
struct VolumeIndices {
  std::span<const std::uint32_t> all;        ///< sides, front cap, back cap: z-fail draws this
  std::span<const std::uint32_t> sides;      ///< the first part of `all`: z-pass draws this
  std::span<const std::uint32_t> front_cap;  ///< counted triangles, where they are
  std::span<const std::uint32_t> back_cap;   ///< the same extruded, reversed
};

/// What is flattened onto a plane.
struct Flat {
  std::span<const std::uint32_t> indices;
  /// No point of the plane is counted more often; nothing where that was not found on the way (ask
  /// Layers).
  std::optional<std::size_t> layers;
  /// To be added to what they count at each point (outline.h).
  int offset = 0;
};

/// The volume of one mesh under a moving light. The vertices never change; a light's move writes
/// indices only, and allocates nothing.
class VolumeBuilder {
 public:
  explicit VolumeBuilder(const scene::Mesh& mesh, scene::Weld weld = {});
  explicit VolumeBuilder(const scene::Adjacency& adjacency);

  /// Each welded vertex p twice: (p, 1) at 2i, and (p, 0) at 2i + 1, which the vertex shader
  /// extrudes: to vec4(p * L.w - L.xyz, 0) for L the light in model space (w ≥ 0), or to a
  /// distance.
  std::span<const glm::vec4> vertices() const { return vertices_; }

  /// `light` in model space; for counts that are exact in GL too, the very floats that the shader
  /// extrudes from. Throws InputError as `normalized_light`. Never refers to an extruded vertex
  /// that is the light itself, whose direction would be 0.
  VolumeIndices build(glm::dvec4 light, const VolumeOptions& options = {});

  /// What is flattened for the shadow on a plane (outline.h), as indices into `vertices()`, three a
  /// triangle, counter-clockwise as the light sees it. Of the options the triangles and the
  /// handedness count. `filling` is outline, around or faces, which around may come to where no
  /// ray tells the offset for certain; none gives nothing. Valid until the next `flat` or `build`.
  Flat flat(glm::dvec4 light, Filling filling, const VolumeOptions& options = {});

  /// The coefficient c of each triangle, by the rules above. Valid until the next `chain` or
  /// `build`.
  std::span<const std::int8_t> chain(glm::dvec4 light, Faces faces = Faces::automatic);

  std::size_t triangle_count() const { return planes_.triangles().size(); }
  /// Triangles in the builder's order, those of inside-out components turned round, of the vertices
  /// of which vertex i is `vertices()[2 * i]`.
  const FacingPlanes& facing() const { return planes_; }

  struct ClosedComponent {
    TriangleRange triangles;
    Component component;
  };
  /// The first triangles of all, in order.
  std::span<const ClosedComponent> closed_components() const { return closed_; }
  /// Edges that `build` looks up one by one, for benchmarks.
  std::size_t indexed_edge_count() const { return edge_triangles_.size() + knot_vertices_.size(); }
  /// How often it compares the coefficients of all triangles with those some places on.
  std::size_t run_count() const { return runs_.size(); }

 private:
  using Index = std::uint32_t;
  // Edges between each triangle t and t + stride, whose boundary is c[t] - c[t + stride]: so many
  // in the order of most meshes, along strips and from strip to strip, that they are compared eight
  // at a time.
  struct Run {
    std::size_t stride = 0;
    std::vector<std::int8_t> edges;  // -1 where there is one, else 0
    std::vector<std::array<Index, 2>> vertices;
  };
  void count(glm::dvec4 light, const VolumeOptions& options);
  void collect_edges(const scene::Adjacency& mesh, std::span<const Index> place,
                     std::span<const std::uint8_t> turned);
  void take_run(std::size_t stride);
  std::span<const Index> boundary_of_edges();
  template <bool quads>
  Index* append_sides(Index* out);
  Index* append_cap(Index* out, std::span<const scene::Triangle> cap) const;

  // Triangles of closed components first, each component's together and turned outward. What has
  // one entry a triangle is filled up with zeros, so that it can be read eight at a time.
  FacingPlanes planes_;
  std::vector<ClosedComponent> closed_;
  std::vector<glm::vec4> vertices_;
  std::vector<scene::Triangle> front_, back_;  // caps of c = 1, as indices into vertices_
  std::vector<Run> runs_;
  // The others of at most two triangles, of opposite directions: c[0] - c[1]; a missing triangle is
  // the one past the end, whose c is 0.
  std::vector<std::array<Index, 2>> edge_triangles_;
  std::vector<std::array<Index, 2>> edge_vertices_;
  // The rest, whose boundary is a sum over their incidences.
  std::vector<std::array<Index, 2>> knot_vertices_;
  std::vector<Index> knot_begin_;
  std::vector<scene::Incidence> knot_incidences_;
  // Scratch and result, of the worst case's size from the start; pages that are never written take
  // no memory.
  std::vector<std::int8_t> chain_;
  std::unique_ptr<Index[]> boundary_;
  std::unique_ptr<Index[]> indices_;
  std::vector<LoopFilling::Edge> outline_;
  LoopFilling filling_;
};

/// A volume with its vertices extruded on the CPU, homogeneous, model space; counter-clockwise seen
/// from outside.
struct VolumeMesh {
  std::vector<glm::dvec4> positions;
  std::vector<std::uint32_t> indices;
  std::size_t side_indices = 0;  ///< the sides are the first this many
};

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Where the vertex p goes: (p·L.w - L.xyz, 0), or `distance` > 0 metres away from the light. (p
/// itself where p is the light and the distance is finite.)
glm::dvec4 extruded(glm::dvec3 p, glm::dvec4 light, double distance = infinite);

/// `mesh`'s volume for `light` (model space). At a finite distance the shadow ends, and behind a
/// triangle that is large compared with its distance from the light it ends sooner than `distance`.
/// Throws InputError where the light is none or the distance is not > 0.
VolumeMesh volume(const scene::Adjacency& adjacency, glm::dvec4 light, Caps caps = Caps::both,
                  double distance = infinite);

}  // namespace shadowlab::shadow
