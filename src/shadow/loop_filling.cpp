#include "shadow/loop_filling.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow {

std::uint32_t* LoopFilling::append(std::span<const Edge> edges, std::size_t vertices,
                                   std::uint32_t* out) {
  // All of leaving_ is `none` here and again at the end, when every edge has been walked.
  if (leaving_.size() < vertices) leaving_.resize(vertices, none);
  next_.resize(edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    next_[e] = leaving_[edges[e][0]];
    leaving_[edges[e][0]] = e;
  }
  loops_.clear();
  ends_.clear();
  for (const Edge& edge : edges) {
    const std::uint32_t start = edge[0];
    while (leaving_[start] != none) {
      loop_.clear();
      std::uint32_t at = start;
      do {
        loop_.push_back(at);
        const std::uint32_t walked = leaving_[at];
        leaving_[at] = next_[walked];
        at = edges[walked][1];
      } while (at != start);
      loops_.insert(loops_.end(), loop_.begin(), loop_.end());
      ends_.push_back(loops_.size());
      for (std::size_t n = loop_.size(); n >= 3; n = (n + 1) / 2) {
        for (std::size_t i = 0; i + 1 < n; i += 2) {
          out[0] = loop_[i];
          out[1] = loop_[i + 1];
          out[2] = loop_[i + 2 < n ? i + 2 : 0];
          out += 3;
        }
        for (std::size_t i = 1; 2 * i < n; ++i) loop_[i] = loop_[2 * i];
      }
    }
  }
  return out;
}

std::optional<std::size_t> LoopFilling::most_windings(std::span<const glm::vec4> vertices,
                                                      glm::dvec4 light) {
  if (loops_.empty()) return 0;
  glm::dvec3 low(1e300), high(-1e300);
  for (const std::uint32_t v : loops_) {
    low = glm::min(low, glm::dvec3(vertices[v]));
    high = glm::max(high, glm::dvec3(vertices[v]));
  }
  // Directions from the light: p·w - L, whatever w.
  const glm::dvec3 from(light), ahead = (low + high) * (0.5 * light.w) - from;
  if (!(glm::length(ahead) > 0)) return {};
  const glm::dvec3 forward = light.w == 0 ? glm::normalize(-from) : glm::normalize(ahead);
  const glm::dvec3 across = glm::normalize(
      glm::cross(forward, std::abs(forward.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(forward, across);
  seen_.clear();
  for (const std::uint32_t v : loops_) {
    const glm::dvec3 p(vertices[v]);
    if (light.w == 0) {
      seen_.emplace_back(glm::dot(p, across), glm::dot(p, up));
      continue;
    }
    const glm::dvec3 toward = p * light.w - from;
    const double depth = glm::dot(toward, forward);
    if (!(depth > 0)) return {};
    seen_.emplace_back(glm::dot(toward, across) / depth, glm::dot(toward, up) / depth);
  }
  std::size_t least = seen_.size();
  for (const glm::dvec2 direction : {glm::dvec2(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
    std::size_t turns = 0, begin = 0;
    for (const std::size_t end : ends_) {
      // Whether it rose last: on a level it goes on as before.
      bool rose = false, first = true, rose_first = false;
      for (std::size_t i = begin; i < end; ++i) {
        const double step = glm::dot(direction, seen_[i + 1 < end ? i + 1 : begin] - seen_[i]);
        if (step == 0) continue;
        if (first) {
          rose_first = step > 0;
        } else if (rose != (step > 0)) {
          ++turns;
        }
        rose = step > 0;
        first = false;
      }
      if (!first && rose != rose_first) ++turns;
      begin = end;
    }
    least = std::min(least, turns / 2);
  }
  return least;
}

}  // namespace shadowlab::shadow
