// What many numbers are summed up by.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace shadowlab::measure {

/// The value below which a share `q` in [0, 1] of `values` lies, interpolated between the two next
/// to it (Hyndman and Fan 1996, type 7). There is at least one value.
double quantile(std::vector<double> values, double q);

struct Quartiles {
  double low = 0, median = 0, high = 0;
  std::size_t count = 0;
};
/// All 0 without values.
Quartiles quartiles(const std::vector<double>& values);

struct Point {
  double x = 0, y = 0;
};

/// y ~ x^exponent: the least-squares line through (log x, log y), and the share of the variance of
/// log y that it explains.
struct PowerLaw {
  double exponent = 0;
  double explained = 0;
};
/// Points with x or y ≤ 0 are left out; nothing where fewer than three places x are left.
std::optional<PowerLaw> power_law(std::span<const Point> points);

/// The indices of the points that no other beats in both x and y (small is good), by rising x. Of
/// equal points the first.
std::vector<std::size_t> pareto_front(std::span<const Point> points);

}  // namespace shadowlab::measure
