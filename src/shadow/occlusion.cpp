#include "shadow/occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace shadowlab::shadow {
namespace {

constexpr int most_cells = 128;  // a side

// Twice the area that o, a, b turn around counter-clockwise.
double turn(glm::dvec2 o, glm::dvec2 a, glm::dvec2 b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

struct Hull {
  std::array<glm::dvec2, 16> corners;
  std::size_t count = 0;
};

// Counter-clockwise, by Andrew's monotone chain.
Hull hull_of(std::array<glm::dvec2, 8> points) {
  std::ranges::sort(
      points, [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Hull hull;
  const auto chain = [&](std::size_t first, glm::dvec2 p) {
    while (hull.count >= first + 2 &&
           turn(hull.corners[hull.count - 2], hull.corners[hull.count - 1], p) <= 0)
      --hull.count;
    hull.corners[hull.count++] = p;
  };
  for (const glm::dvec2& p : points) chain(0, p);
  const std::size_t upper = --hull.count;
  for (std::size_t i = points.size(); i-- > 0;) chain(upper, points[i]);
  --hull.count;
  return hull;
}

}  // namespace

Occlusion::Occlusion(glm::ivec2 picture)
    : picture_(picture),
      cell_((std::max(picture.x, picture.y) + most_cells - 1) / most_cells),
      cells_((picture + cell_ - 1) / cell_),
      depths_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y),
              std::numeric_limits<float>::infinity()) {}

void Occlusion::add(const std::array<glm::dvec2, 8>& corners, double farthest) {
  const Hull hull = hull_of(corners);
  if (hull.count < 3) return;
  glm::dvec2 low = hull.corners[0], high = low;
  for (std::size_t i = 1; i < hull.count; ++i) {
    low = glm::min(low, hull.corners[i]);
    high = glm::max(high, hull.corners[i]);
  }
  const auto depth = static_cast<float>(farthest * (1 + 1e-6));
  const double half = 0.5 * cell_ + 1;  // a cell and the pixel around it
  const auto first = [&](double v) { return std::max(0, int(std::clamp(v / cell_, 0.0, 1e6))); };
  const int bottom = first(low.y), top = std::min(cells_.y - 1, first(high.y));
  for (int y = bottom; y <= top; ++y) {
    const double middle = (y + 0.5) * cell_;
    double from = low.x, to = high.x;  // where the middles of covered cells are
    for (std::size_t i = 0; i < hull.count; ++i) {
      const glm::dvec2 a = hull.corners[i], along = hull.corners[(i + 1) % hull.count] - a;
      // Inside: along.x (y - a.y) - along.y (x - a.x) >= 0, at the cell's worst corner.
      const double rest =
          along.x * (middle - a.y) + along.y * a.x - half * (std::abs(along.x) + std::abs(along.y));
      if (along.y > 0) {
        to = std::min(to, rest / along.y);
      } else if (along.y < 0) {
        from = std::max(from, rest / along.y);
      } else if (rest < 0) {
        to = from - 1;
      }
    }
    if (to < from) continue;
    const int left = std::max(0, int(std::ceil(std::max(from / cell_ - 0.5, -1.0)))),
              right = int(std::floor(std::min(to / cell_ - 0.5, double(cells_.x - 1))));
    float* const row = depths_.data() + static_cast<std::ptrdiff_t>(y) * cells_.x;
    for (int x = left; x <= right; ++x) row[x] = std::min(row[x], depth);
  }
}

bool Occlusion::hides(const Extent& extent) const {
  const auto cell = [&](double pixel, int count) {
    return int(std::clamp(std::floor(pixel / cell_), 0.0, double(count - 1)));
  };
  const int left = cell(extent.low.x - 1, cells_.x), right = cell(extent.high.x + 1, cells_.x),
            bottom = cell(extent.low.y - 1, cells_.y), top = cell(extent.high.y + 1, cells_.y);
  for (int y = bottom; y <= top; ++y) {
    const float* const row = depths_.data() + static_cast<std::ptrdiff_t>(y) * cells_.x;
    for (int x = left; x <= right; ++x) {
      if (!(double(row[x]) < extent.nearest)) return false;
    }
  }
  return true;
}

}  // namespace shadowlab::shadow
