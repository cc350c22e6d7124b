#include "measure/errors.h"

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"

namespace shadowlab::measure {
namespace {

double difference(float technique, float truth) {
  const double off = std::abs(double{technique} - double{truth});
  return off <= 1 ? off : 1;  // also what is not a number
}

class MeanSquare {
 public:
  void add(double off) {
    sum_ += off * off;
    ++count_;
  }
  std::optional<double> root() const {
    if (count_ == 0) return {};
    return std::sqrt(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

Errors errors_of(const image::FloatImage& technique, const Truth& truth,
                 const std::vector<std::uint8_t>& compared) {
  Errors errors;
  errors.bar = truth.bar;
  MeanSquare all, umbra, penumbra, lit;
  std::vector<double> offs;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (compared[i] == 0) continue;
    const float expected = truth.visibility.values[i];
    const double off = difference(technique.values[i], expected);
    offs.push_back(off);
    all.add(off);
    (expected <= 0 ? umbra : expected < 1 ? penumbra : lit).add(off);
    const bool wrong = off > 0.5;
    errors.wrong += wrong;
    errors.wrong_beyond_edge += wrong && truth.edges.values[i] == 0;
    if (off > errors.worst) {
      errors.worst = off;
      errors.worst_x = static_cast<int>(i) % technique.width;
      errors.worst_y = static_cast<int>(i) / technique.width;
    }
  }
  errors.pixels = offs.size();
  if (offs.empty()) return errors;
  errors.rmse = *all.root();
  errors.p99 = quantile(std::move(offs), 0.99);
  errors.umbra = umbra.root();
  errors.penumbra = penumbra.root();
  errors.lit = lit.root();
  return errors;
}

image::FloatImage error_map(const image::FloatImage& technique, const Truth& truth,
                            const std::vector<std::uint8_t>& compared) {
  image::FloatImage map = technique;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double off = difference(technique.values[i], truth.visibility.values[i]);
    map.values[i] = compared[i] != 0 ? static_cast<float>(off) : 0;
  }
  return map;
}

}  // namespace shadowlab::measure
