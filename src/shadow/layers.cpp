#include "shadow/layers.h"

#include <algorithm>
#include <cmath>

#include "shadow/convex.h"

namespace shadowlab::shadow {
namespace {

// Of the part of a direction that rounding may take: that of a few operations in double.
constexpr double rounding = 1e-14;
constexpr int deepest = 14;
// Cells in which each triangle is looked for, on average, before bounds found so far have to do.
constexpr std::size_t tests_each = 20;
constexpr std::size_t least_tests = 20'000;
constexpr std::uint32_t none = 0xFFFFFFFF;

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

Layers::Layers(VolumeBuilder& builder) : builder_(builder) {
  convex_.assign(builder.triangle_count(), none);
  const auto closed = builder.closed_components();
  for (Index c = 0; c < closed.size(); ++c) {
    if (!is_convex(builder.facing(), closed[c].triangles)) continue;
    std::fill(convex_.begin() + static_cast<std::ptrdiff_t>(closed[c].triangles.first),
              convex_.begin() + static_cast<std::ptrdiff_t>(closed[c].triangles.last), c);
  }
  crossed_twice_.resize(closed.size());
  seen_.resize(builder.facing().positions().size());
  // What quartering takes for most casters and lights, so that a light that moves allocates
  // nothing; for large ones the vectors grow as far as a light makes them.
  const std::size_t room = 16 * std::min<std::size_t>(builder.triangle_count(), 1 << 16);
  triangles_.reserve(room);
  edges_.reserve(room);
  cells_.reserve(1024);
}

std::span<const Part> Layers::parts(glm::dvec4 light, std::size_t most) {
  light = normalized_light(light);
  if (!parts_.empty() && light == light_ && most == most_) return parts_;
  light_ = light;
  most_ = most;
  parts_.clear();
  const auto chain = builder_.chain(light);
  chain_.assign(chain.begin(), chain.end());
  const auto closed = builder_.closed_components();
  for (std::size_t c = 0; c < closed.size(); ++c) {
    crossed_twice_[c] = closed[c].component.lit_faces_suffice(light) ? 0 : 1;
  }
  toward_middle_ = toward_middle();
  frame_.reset();
  tests_left_ = tests_each * chain_.size() + least_tests;
  split({0, builder_.triangle_count()});
  return parts_;
}

void Layers::split(TriangleRange range) {
  const std::size_t layers = bound(range);
  if (layers <= most_) {
    parts_.push_back({range, layers});
    return;
  }
  const std::size_t middle = range.first + range.count() / 2;
  split({range.first, middle});
  split({middle, range.last});
}

// A bound that needs no geometry. Those of a convex component are in one run.
std::size_t Layers::weight(std::span<const Index> triangles) const {
  std::size_t sum = 0;
  Index last = none;
  for (const Index t : triangles) {
    const Index component = convex_[t];
    if (component == none) {
      ++sum;
    } else if (component != last) {
      sum += crossed_twice_[component] != 0 ? 2 : 1;
    }
    last = component;
  }
  return sum;
}

std::size_t Layers::bound(TriangleRange range) {
  triangles_.clear();
  for (std::size_t t = range.first; t < range.last; ++t) {
    if (chain_[t] != 0) triangles_.push_back(static_cast<Index>(t));
  }
  const std::size_t sum = weight(triangles_);
  // The builder looks at all triangles, eight at a time.
  const std::size_t tests = triangles_.size() + chain_.size() / 8;
  if (sum <= enough() || tests_left_ < tests) return sum;
  tests_left_ -= tests;
  edges_.clear();
  const auto sides = builder_.build(light_, {.caps = Caps::none, .triangles = range}).sides;
  for (std::size_t i = 0; i < sides.size(); i += light_.w == 0 ? 3 : 6) {
    edges_.push_back({sides[i] / 2, sides[i + 1] / 2});
  }
  const Cell all{{}, 0, 0, triangles_.size(), edges_.size(), sum, 0};
  cells_.clear();
  too_many_ = false;
  // All within sight around the way to the middle, or else a cube's six faces.
  look_along(toward_middle_);
  if (const auto window = around(triangles_)) {
    look_into(*window, all);
    return quartered();
  }
  std::size_t most = 0;
  const Window face{glm::dvec2(-1 - rounding), glm::dvec2(1 + rounding)};
  for (int axis = 0; axis < 3 && most <= most_; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      glm::dmat3 frame(0);
      frame[0][(axis + 1) % 3] = frame[1][(axis + 2) % 3] = 1;
      frame[2][axis] = sign;
      look_along(frame);
      cells_.clear();
      triangles_.resize(all.triangles_end);
      edges_.resize(all.edges_end);
      look_into(face, all);
      most = std::max(most, quartered());
    }
  }
  return most;
}

// The bound for all cells: that of the worst, which is quartered until that is little or in vain.
std::size_t Layers::quartered() {
  const auto less = [](const Cell& a, const Cell& b) { return a.layers < b.layers; };
  while (true) {
    const Cell worst = cells_.front();
    const std::size_t tests = worst.triangles_end - worst.triangles + worst.edges_end - worst.edges;
    if (worst.layers <= enough() || worst.depth == deepest || too_many_ || tests > tests_left_)
      return worst.layers;
    tests_left_ -= tests;
    std::pop_heap(cells_.begin(), cells_.end(), less);
    cells_.pop_back();
    const glm::dvec2 middle = (worst.window.low + worst.window.high) * 0.5;
    for (int quarter = 0; quarter < 4; ++quarter) {
      Window part = worst.window;
      ((quarter & 1) != 0 ? part.low.x : part.high.x) = middle.x;
      ((quarter & 2) != 0 ? part.low.y : part.high.y) = middle.y;
      look_into(part, worst);
      std::push_heap(cells_.begin(), cells_.end(), less);
    }
  }
}

// Adds the cell of what is in the window.
void Layers::look_into(const Window& window, const Cell& all) {
  Cell cell{window, triangles_.size(), edges_.size(), 0, 0, 0, all.depth + 1};
  for (std::size_t i = all.triangles; i < all.triangles_end; ++i) {
    const Index t = triangles_[i];
    if (reaches_into(builder_.facing().triangles()[t], window)) triangles_.push_back(t);
  }
  for (std::size_t i = all.edges; i < all.edges_end; ++i) {
    const auto edge = edges_[i];
    if (reaches_into(edge, window)) edges_.push_back(edge);
  }
  cell.triangles_end = triangles_.size();
  cell.edges_end = edges_.size();
  const auto triangles = std::span(triangles_).subspan(cell.triangles);
  const std::size_t edges = cell.edges_end - cell.edges;
  cell.layers = std::min(all.layers, weight(triangles));
  if (cell.layers > edges || all.depth == 0) {
    const Met met = met_along((window.low + window.high) * 0.5, triangles);
    cell.layers = std::min(cell.layers, edges + met.most);
    too_many_ = too_many_ || met.least > most_;
  }
  cells_.push_back(cell);
}

// False only where all are beyond one side of the window, or behind the light.
bool Layers::reaches_into(std::span<const Index> vertices, const Window& window) const {
  bool left = true, right = true, under = true, over = true, behind = true;
  for (const Index v : vertices) {
    const glm::dvec4& p = seen_[v];
    left = left && p.x < window.low.x * p.z - p.w;
    right = right && p.x > window.high.x * p.z + p.w;
    under = under && p.y < window.low.y * p.z - p.w;
    over = over && p.y > window.high.y * p.z + p.w;
    behind = behind && p.z < -p.w;
  }
  return !(left || right || under || over || behind);
}

Layers::Met Layers::met_along(glm::dvec2 direction, std::span<const Index> triangles) const {
  const glm::dvec3 ray(direction, 1);
  Met met;
  for (const Index t : triangles) {
    const auto& corners = builder_.facing().triangles()[t];
    bool ccw = true, cw = true, certain = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 p(seen_[corners[k]]), q(seen_[corners[(k + 1) % 3]]);
      const double side = glm::dot(glm::cross(p, q), ray);
      const double error = 10 * rounding * size_of(p) * size_of(q) * size_of(ray);
      ccw = ccw && side >= -error;
      cw = cw && side <= error;
      // In front of the light too, or the ray meets it the other way.
      certain = certain && std::abs(side) > error && p.z > 0;
    }
    met.most += ccw || cw ? 1 : 0;
    met.least += (ccw || cw) && certain ? 1 : 0;
  }
  return met;
}

// The light's way to the middle of the vertices, last, and two across it.
glm::dmat3 Layers::toward_middle() const {
  glm::dvec3 forward = -glm::dvec3(light_);
  if (light_.w != 0) {
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::vec3& p : builder_.facing().positions()) {
      low = glm::min(low, glm::dvec3(p));
      high = glm::max(high, glm::dvec3(p));
    }
    forward = (low + high) * 0.5 * light_.w - glm::dvec3(light_);
  }
  const glm::dvec3 size = glm::abs(forward);
  const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                           : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                : glm::dvec3(0, 0, 1);
  if (size_of(forward) == 0) return glm::dmat3(1);
  forward = glm::normalize(forward);
  const glm::dvec3 across = glm::normalize(glm::cross(other, forward));
  return {across, glm::cross(forward, across), forward};
}

void Layers::look_along(const glm::dmat3& frame) {
  if (frame_ == frame) return;
  frame_ = frame;
  const auto positions = builder_.facing().positions();
  const glm::dvec3 light(light_);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 away = glm::dvec3(positions[i]) * light_.w - light;
    // As a row: the frame's columns are where the coordinates point.
    const glm::dvec3 p = light_.w == 0 ? glm::dvec3(positions[i]) * frame : away * frame;
    seen_[i] = {p.x, p.y, light_.w == 0 ? 1 : p.z,
                rounding * (size_of(positions[i]) * std::max(1.0, light_.w) + size_of(light))};
  }
}

// Where all of them are seen; nothing where one reaches behind the light.
std::optional<Layers::Window> Layers::around(std::span<const Index> triangles) const {
  Window window{glm::dvec2(+1e300), glm::dvec2(-1e300)};
  for (const Index t : triangles) {
    for (const Index v : builder_.facing().triangles()[t]) {
      const glm::dvec4& p = seen_[v];
      if (p.z <= 1e-3 * size_of(glm::dvec3(p)) + 2 * p.w) return {};
      const glm::dvec2 at = glm::dvec2(p) / p.z;
      const double error = 4 * p.w / p.z;
      window.low = glm::min(window.low, at - error);
      window.high = glm::max(window.high, at + error);
    }
  }
  return window;
}

}  // namespace shadowlab::shadow
