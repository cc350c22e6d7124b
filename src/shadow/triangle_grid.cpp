#include "shadow/triangle_grid.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "shadow/facing.h"
#include "shadow/triangle_shadow.h"
#include "shadow/view_frustum.h"

namespace shadowlab::shadow {
namespace {

// A cell is grown by this, in cells: a float's rounding of a place on the map may take the next
// one.
constexpr double growth = 0.01;

// A caster's triangle over the map: x and y in cells, z the depth, which is affine in them.
struct Piece {
  std::array<glm::dvec3, 3> corners;
  std::uint32_t triangle;
  double nearest;
};

class Cells {
 public:
  explicit Cells(int cells)
      : cells_(cells),
        lists_(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells)),
        covered_(lists_.size(), 1e300) {}

  void add(const Piece& piece) {
    const auto& [a, b, c] = piece.corners;
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;  // edge on: it shadows nothing
    const glm::dvec2 low = glm::min(glm::dvec2(a), glm::min(glm::dvec2(b), glm::dvec2(c)));
    const glm::dvec2 high = glm::max(glm::dvec2(a), glm::max(glm::dvec2(b), glm::dvec2(c)));
    if (high.x < -growth || high.y < -growth || low.x > cells_ + growth || low.y > cells_ + growth)
      return;
    Sides sides;
    for (std::size_t i = 0; i < 3; ++i)
      sides[i] = side_of(piece.corners[i], piece.corners[(i + 1) % 3], area);
    const glm::dvec2 slope = glm::dvec2((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y),
                                        (c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) /
                             area;
    for (int y = cell_of(low.y - growth); y <= cell_of(high.y + growth); ++y) {
      for (int x = cell_of(low.x - growth); x <= cell_of(high.x + growth); ++x)
        visit(piece, sides, slope, x, y);
    }
  }

  void give(TriangleGrid& grid) const {
    grid.ranges.reserve(lists_.size());
    for (const auto& list : lists_) {
      grid.ranges.emplace_back(grid.list.size(), list.size());
      grid.list.insert(grid.list.end(), list.begin(), list.end());
      grid.longest = std::max(grid.longest, list.size());
    }
  }

 private:
  using Sides = std::array<glm::dvec3, 3>;  // n·p + d > 0 inside

  static glm::dvec3 side_of(glm::dvec3 a, glm::dvec3 b, double area) {
    const glm::dvec2 n = glm::dvec2(a.y - b.y, b.x - a.x) * (area > 0 ? 1.0 : -1.0);
    return {n, -glm::dot(n, glm::dvec2(a))};
  }

  int cell_of(double place) const {
    return static_cast<int>(std::clamp(std::floor(place), 0.0, cells_ - 1.0));
  }

  void visit(const Piece& piece, const Sides& sides, glm::dvec2 slope, int x, int y) {
    const std::size_t cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_) +
                             static_cast<std::size_t>(x);
    const glm::dvec3 middle(x + 0.5, y + 0.5, 1);
    const double depth =
        piece.corners[0].z + glm::dot(slope, glm::dvec2(middle - piece.corners[0]));
    const double spread = (0.5 + growth) * (std::abs(slope.x) + std::abs(slope.y));
    // Rounding must not drop what touches the covering triangle.
    if (std::max(piece.nearest, depth - spread) > covered_[cell] + 1e-9) return;
    bool covers = true;
    for (const glm::dvec3& side : sides) {
      const double at_middle = glm::dot(side, middle);
      const double reach = (0.5 + growth) * (std::abs(side.x) + std::abs(side.y));
      if (at_middle < -reach) return;
      covers = covers && at_middle > reach;
    }
    auto& list = lists_[cell];
    list.push_back(piece.triangle);
    if (!covers) return;
    if (depth + spread >= covered_[cell]) return;
    covered_[cell] = depth + spread;
    std::swap(list.front(), list.back());  // most of what is dark is so by this one
  }

  int cells_;
  std::vector<std::vector<std::uint32_t>> lists_;
  std::vector<double> covered_;  // the depth behind which all is dark
};

glm::vec4 first_bits(glm::dvec4 value) { return glm::vec4(value); }
glm::vec4 next_bits(glm::dvec4 value) { return glm::vec4(value - glm::dvec4(glm::vec4(value))); }

void append_record(std::vector<glm::vec4>& triangles, const std::array<glm::dvec3, 3>& corners,
                   const TriangleShadow& shadow) {
  const std::size_t end = triangles.size() + TriangleGrid::texels;
  const std::array<glm::dvec4, 4> planes{shadow.own, shadow.edges[0], shadow.edges[1],
                                         shadow.edges[2]};
  for (const glm::dvec4& plane : planes) triangles.push_back(first_bits(plane));
  for (const glm::dvec4& plane : planes) triangles.push_back(next_bits(plane));
  for (const glm::dvec3& corner : corners) {
    triangles.push_back(first_bits(glm::dvec4(corner, 0)));
    triangles.push_back(next_bits(glm::dvec4(corner, 0)));
  }
  triangles.resize(end);
}

// A point light itself; for one at infinity a place amid the scene.
glm::dvec3 origin_for(const scene::Scene& scene, glm::dvec4 light) {
  if (light.w != 0) return glm::dvec3(light) / light.w;
  scene::Bounds all;
  for (const scene::Object& object : scene.objects)
    all = scene::merge(all, scene::bounds(*object.mesh, object.model));
  return all.empty() ? glm::dvec3(0) : all.center();
}

// The light's window in cells.
struct Window {
  glm::dmat4 to_clip;
  double least;  // of w: what is nearer to the light is in no map
  int cells;
};

Window window_of(const glm::dmat4& view, const glm::dmat4& projection, int cells) {
  // The near plane of a frustum; w is 1 where there is none.
  const bool perspective = projection[2][3] != 0;
  const double near = perspective ? projection[3][2] / (projection[2][2] - 1) : 1;
  return {projection * view, 0.5 * near, cells};
}

void append_pieces(std::vector<Piece>& pieces, const std::array<glm::dvec3, 3>& corners,
                   const Window& window, std::uint32_t triangle) {
  const glm::dmat4& m = window.to_clip;
  const glm::dvec4 before(m[0].w, m[1].w, m[2].w, m[3].w - window.least);
  const Polygon polygon = clipped(corners, before);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    Piece piece{{}, triangle, 1e300};
    const std::array<glm::dvec3, 3> fan{polygon[0], polygon[i - 1], polygon[i]};
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec4 clip = m * glm::dvec4(fan[k], 1);
      const glm::dvec3 place = glm::dvec3(clip) / clip.w;
      piece.corners[k] = {(place.x + 1) * (0.5 * window.cells),
                          (place.y + 1) * (0.5 * window.cells), place.z};
      piece.nearest = std::min(piece.nearest, place.z);
    }
    pieces.push_back(piece);
  }
}

}  // namespace

TriangleGrid triangle_grid(const scene::Scene& scene, glm::dvec4 light, const glm::dmat4& view,
                           const glm::dmat4& projection, int cells) {
  if (cells < 1 || cells > 4096)
    throw InputError("A grid of triangles has 1 to 4096 cells a side.");
  light = normalized_light(light);
  TriangleGrid grid;
  grid.origin = origin_for(scene, light);
  Window window = window_of(view, projection, cells);
  window.to_clip = glm::translate(window.to_clip, grid.origin);
  std::vector<Piece> pieces;
  std::uint32_t number = 0;
  for (const scene::Object& object : scene.objects) {
    const scene::Mesh& mesh = *object.mesh;
    glm::dmat4 model = object.model;
    model[3] -= glm::dvec4(grid.origin, 0);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t, ++number) {
      std::array<glm::dvec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = model * glm::dvec4(mesh.positions[mesh.indices[3 * t + k]], 1);
      const TriangleShadow shadow = triangle_shadow(corners, light);
      append_record(grid.triangles, corners, shadow);
      if (object.casts() && shadow.own != glm::dvec4(0))
        append_pieces(pieces, corners, window, number);
    }
  }
  std::ranges::stable_sort(pieces, {}, &Piece::nearest);
  Cells sorted(cells);
  for (const Piece& piece : pieces) sorted.add(piece);
  sorted.give(grid);
  return grid;
}

}  // namespace shadowlab::shadow
