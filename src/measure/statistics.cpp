#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace shadowlab::measure {

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  const double place = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

Quartiles quartiles(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75), values.size()};
}

std::optional<PowerLaw> power_law(std::span<const Point> points) {
  std::vector<Point> logs;
  std::set<double> places;
  for (const Point& point : points) {
    if (!(point.x > 0 && point.y > 0)) continue;
    logs.push_back({std::log(point.x), std::log(point.y)});
    places.insert(point.x);
  }
  if (places.size() < 3) return {};
  Point mean;
  for (const Point& p : logs) {
    mean.x += p.x / static_cast<double>(logs.size());
    mean.y += p.y / static_cast<double>(logs.size());
  }
  double xx = 0, xy = 0, yy = 0;
  for (const Point& p : logs) {
    xx += (p.x - mean.x) * (p.x - mean.x);
    xy += (p.x - mean.x) * (p.y - mean.y);
    yy += (p.y - mean.y) * (p.y - mean.y);
  }
  return PowerLaw{xy / xx, yy > 0 ? xy * xy / (xx * yy) : 1};
}

std::vector<std::size_t> pareto_front(std::span<const Point> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || points[i].y < points[front.back()].y) front.push_back(i);
  }
  return front;
}

}  // namespace shadowlab::measure
