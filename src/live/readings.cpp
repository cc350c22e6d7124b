#include "live/readings.h"

#include <algorithm>

namespace shadowlab::live {
namespace {

constexpr double legible = 0.25;  // seconds

}  // namespace

void Readings::add(double frame_ms, std::span<const PassReport> passes, double seconds) {
  const bool others = !std::ranges::equal(passes, names_, {}, &PassReport::name);
  if (others || frames_ == 0) {
    names_.clear();
    for (const PassReport& pass : passes) names_.push_back(pass.name);
    sum_ = {0, std::vector<double>(passes.size())};
    frames_ = 0;
  }
  sum_.frame += frame_ms;
  for (std::size_t i = 0; i < passes.size(); ++i) sum_.passes[i] += passes[i].milliseconds;
  ++frames_;
  age_ += seconds;
  if (!others && age_ < legible) return;
  shown_ = sum_;
  shown_.frame /= frames_;
  for (double& time : shown_.passes) time /= frames_;
  frames_ = 0;
  age_ = 0;
}

}  // namespace shadowlab::live
