#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "truth/parallel_rows.h"
#include "truth/traced_scene.h"
#include "truth/tracer.h"
#include "truth/tracer_parts.h"

namespace shadowlab::truth {
namespace {

// Rows of pixels whose lattice is held at once: the lattice's two rows of overlap are traced twice.
constexpr int kBandRows = 16;

// How near to an edge a rasteriser may take a pixel's centre for the other side: GL promises
// vertices snapped to 1/16 of a pixel or finer and implementations snap to 1/256; twice that.
constexpr double kSnap = 1.0 / 128;

struct LatticePoint {
  const Triangle* triangle = nullptr;  ///< null: background
  glm::dvec3 ray{0};                   ///< of unit depth
  double depth = 0;
  bool lit = true;
};

// The depth at which `ray` from `eye` meets the plane of `triangle`.
double plane_depth(const Triangle& triangle, glm::dvec3 eye, glm::dvec3 ray) {
  const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return glm::dot(normal, triangle.a - eye) / glm::dot(normal, ray);
}

// Whether the step in depth from p to q is one that a surface made of their two planes can take: at
// most what the planes do over the step, together. A fold, or a sheet before another, steps
// further.
bool same_sheet(const LatticePoint& p, const LatticePoint& q, glm::dvec3 eye) {
  if (p.triangle == q.triangle) return true;
  if (p.triangle == nullptr || q.triangle == nullptr) return false;
  if (p.triangle->object != q.triangle->object) return false;
  const double by_p = std::abs(plane_depth(*p.triangle, eye, q.ray) - p.depth);
  const double by_q = std::abs(plane_depth(*q.triangle, eye, p.ray) - q.depth);
  // 1e-12: the rounding of a depth, for planes that face the eye squarely and so do nothing.
  return std::abs(p.depth - q.depth) <= by_p + by_q + 1e-12 * p.depth;
}

}  // namespace

image::FloatImage Tracer::edge_mask(const scene::Camera& camera, const scene::Light& light,
                                    int width, int height, int per_pixel, int threads) const {
  if (per_pixel < 1 || per_pixel > 64) {
    throw InputError(
        fmt::format("An edge mask takes 1 to 64 lattice points a pixel, not {}.", per_pixel));
  }
  const View view(camera, parts_->center(), width, height);
  const glm::dvec4 position = parts_->relative(light.position);
  const int columns = per_pixel * (width + 1) + 1;
  image::FloatImage mask{width, height, {}};
  mask.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

  const int bands = (height + kBandRows - 1) / kBandRows;
  parallel_rows(bands, threads, [&](int band) {
    const int first = band * kBandRows;
    const int rows_of_pixels = std::min(kBandRows, height - first);
    const int rows = per_pixel * (rows_of_pixels + 1) + 1;
    std::vector<LatticePoint> lattice(static_cast<std::size_t>(rows) *
                                      static_cast<std::size_t>(columns));
    const auto at = [&](int i, int j) -> LatticePoint& {
      return lattice[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(i)];
    };
    const Triangle* last = nullptr;
    const auto trace = [&](double x, double y) {
      LatticePoint point{.ray = view.direction(x, y)};
      if (const auto hit = parts_->first_hit(view, x, y)) {
        point.triangle = hit->triangle;
        point.depth = hit->depth;
        point.lit = !parts_->shadowed(*hit, view.eye, position, last);
      }
      return point;
    };
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        // Point (0, 0) is one pixel before the centre of the band's first pixel, in x and in y.
        at(i, j) = trace(static_cast<double>(i) / per_pixel - 0.5,
                         first + static_cast<double>(j) / per_pixel - 0.5);
      }
    }
    const auto cut = [&](const LatticePoint& p, const LatticePoint& q) {
      return p.lit != q.lit || !same_sheet(p, q, view.eye);
    };
    // A cut between lattice points (i, j) and (i2, j2) marks each pixel whose square holds both:
    // pixel X holds the columns per_pixel X to per_pixel (X + 2), and rows alike.
    const auto mark = [&](int i, int j, int i2, int j2) {
      const int left = std::max((i2 + per_pixel - 1) / per_pixel - 2, 0);
      const int top = std::max((j2 + per_pixel - 1) / per_pixel - 2, 0);
      for (int y = top; y <= std::min(j / per_pixel, rows_of_pixels - 1); ++y) {
        for (int x = left; x <= std::min(i / per_pixel, width - 1); ++x) {
          mask.values[static_cast<std::size_t>(first + y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)] = 1;
        }
      }
    };
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        if (i + 1 < columns && cut(at(i, j), at(i + 1, j))) mark(i, j, i + 1, j);
        if (j + 1 < rows && cut(at(i, j), at(i, j + 1))) mark(i, j, i, j + 1);
      }
    }
    // What is narrower than the lattice and passes beside a pixel's centre. An edge within kSnap of
    // the centre parts it from a corner of the square of that half-side.
    for (int y = 0; y < rows_of_pixels; ++y) {
      for (int x = 0; x < width; ++x) {
        float& marked =
            mask.values[static_cast<std::size_t>(first + y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)];
        const LatticePoint& center = at(per_pixel * (x + 1), per_pixel * (y + 1));
        for (int corner = 0; corner < 4 && marked == 0; ++corner) {
          const double dx = (corner & 1) != 0 ? kSnap : -kSnap;
          const double dy = (corner & 2) != 0 ? kSnap : -kSnap;
          if (cut(center, trace(x + 0.5 + dx, first + y + 0.5 + dy))) marked = 1;
        }
      }
    }
  });
  return mask;
}

}  // namespace shadowlab::truth
