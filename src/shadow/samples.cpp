#include "shadow/samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::shadow {
namespace {

constexpr std::array<std::string_view, 7> kNames{"random", "jitter", "grid", "hammersley",
                                                 "r2",     "sobol",  "owen"};

// A bijection of 64-bit words in which each input bit reaches each output bit (Steele, Lea and
// Flood 2014, the finaliser of SplitMix64). Counter in, random word out: no state, so points are
// nested and the same on every machine.
std::uint64_t mix(std::uint64_t word) {
  word += 0x9E3779B97F4A7C15u;
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9u;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBu;
  return word ^ (word >> 31);
}

double unit(std::uint64_t word) { return static_cast<double>(word >> 11) * 0x1p-53; }
double unit(std::uint32_t word) { return static_cast<double>(word) * 0x1p-32; }

glm::dvec2 random_point(std::uint64_t index, std::uint64_t seed) {
  const std::uint64_t stream = mix(seed);
  return {unit(mix(stream ^ (2 * index))), unit(mix(stream ^ (2 * index + 1)))};
}

std::uint32_t reversed_bits(std::uint32_t word) {
  word = ((word & 0x55555555u) << 1) | ((word >> 1) & 0x55555555u);
  word = ((word & 0x33333333u) << 2) | ((word >> 2) & 0x33333333u);
  word = ((word & 0x0F0F0F0Fu) << 4) | ((word >> 4) & 0x0F0F0F0Fu);
  word = ((word & 0x00FF00FFu) << 8) | ((word >> 8) & 0x00FF00FFu);
  return (word << 16) | (word >> 16);
}

// Sobol 1967. First dimension: the radical inverse. Second: the primitive polynomial x + 1, whose
// direction numbers are the rows of Pascal's triangle modulo 2, v[k] = v[k-1] xor v[k-1]/2.
std::array<std::uint32_t, 2> sobol_word(std::uint32_t index) {
  std::uint32_t second = 0;
  for (std::uint32_t direction = 0x80000000u, bits = index; bits != 0; bits >>= 1) {
    if (bits & 1u) second ^= direction;
    direction ^= direction >> 1;
  }
  return {reversed_bits(index), second};
}

// Nested uniform scrambling, Owen 1995: each digit is flipped by a coin that belongs to the digits
// above it, a binary tree of coins. Six levels hold 63 coins: one word of 64 bits for each subtree
// that is met, nodes numbered as in a heap.
std::uint32_t owen_scrambled(std::uint32_t word, std::uint64_t seed) {
  std::uint32_t scrambled = 0;
  for (int level = 0; level < 32; level += 6) {
    const std::uint64_t prefix = level == 0 ? 0 : word >> (32 - level);
    const std::uint64_t coins = mix(mix(seed + static_cast<std::uint64_t>(level)) ^ prefix);
    unsigned node = 1;
    for (int bit = level; bit < std::min(level + 6, 32); ++bit) {
      const std::uint32_t digit = (word >> (31 - bit)) & 1u;
      const auto coin = static_cast<std::uint32_t>((coins >> node) & 1u);
      scrambled |= (digit ^ coin) << (31 - bit);
      node = 2 * node + digit;
    }
  }
  return scrambled;
}

// The unit square cut into n cells of equal area 1/n, for any n: about √n rows, whose heights are
// in proportion to their share of the cells.
struct Cell {
  glm::dvec2 low;
  glm::dvec2 size;
};

std::vector<Cell> cells(int n) {
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(n))));
  std::vector<Cell> result;
  result.reserve(static_cast<std::size_t>(n));
  for (int row = 0; row < rows; ++row) {
    const auto first = static_cast<int>(static_cast<std::int64_t>(n) * row / rows);
    const auto next = static_cast<int>(static_cast<std::int64_t>(n) * (row + 1) / rows);
    const int columns = next - first;
    for (int column = 0; column < columns; ++column) {
      result.push_back({{static_cast<double>(column) / columns, static_cast<double>(first) / n},
                        {1.0 / columns, static_cast<double>(columns) / n}});
    }
  }
  return result;
}

glm::dvec2 r2_point(std::uint32_t index) {
  // Roberts 2018: the plastic number g is the real root of g³ = g + 1.
  constexpr double kPlastic = 1.32471795724474602596;
  const double i = index;
  const double x = 0.5 + i / kPlastic;
  const double y = 0.5 + i / (kPlastic * kPlastic);
  return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace

std::span<const std::string_view> pattern_names() { return kNames; }

std::optional<Pattern> pattern_named(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Pattern>(found - kNames.begin());
}

bool is_nested(Pattern pattern) {
  return pattern == Pattern::random || pattern == Pattern::r2 || pattern == Pattern::sobol ||
         pattern == Pattern::owen;
}

bool is_seeded(Pattern pattern) {
  return pattern == Pattern::random || pattern == Pattern::jitter || pattern == Pattern::owen;
}

glm::dvec2 owen_point(std::uint32_t index, std::uint64_t seed) {
  const auto [x, y] = sobol_word(index);
  const std::uint64_t stream = mix(seed);
  return {unit(owen_scrambled(x, stream)), unit(owen_scrambled(y, mix(stream)))};
}

std::vector<glm::dvec2> unit_square_points(int n, Pattern pattern, std::uint64_t seed) {
  if (n < 1 || n > (1 << 24)) {
    throw InputError(
        fmt::format("shadow.samples: {} points were asked for; 1 to {} can be had.", n, 1 << 24));
  }
  std::vector<glm::dvec2> points;
  points.reserve(static_cast<std::size_t>(n));
  if (pattern == Pattern::jitter || pattern == Pattern::grid) {
    for (const Cell& cell : cells(n)) {
      const glm::dvec2 inside =
          pattern == Pattern::grid ? glm::dvec2(0.5) : random_point(points.size(), seed);
      points.push_back(cell.low + cell.size * inside);
    }
    return points;
  }
  // Radical inverses are the lower ends of cells of this height: their mean is 1/2 less half of it.
  const double half_cell = 0.5 / static_cast<double>(std::bit_ceil(static_cast<unsigned>(n)));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
    switch (pattern) {
      case Pattern::hammersley:
        points.emplace_back((i + 0.5) / n, unit(reversed_bits(i)) + half_cell);
        break;
      case Pattern::r2:
        points.push_back(r2_point(i));
        break;
      case Pattern::sobol: {
        const auto [x, y] = sobol_word(i);
        points.emplace_back(unit(x), unit(y));
        break;
      }
      case Pattern::owen:
        points.push_back(owen_point(i, seed));
        break;
      default:
        points.push_back(random_point(i, seed));
        break;
    }
  }
  return points;
}

glm::dvec3 point_on_light(const scene::Light& light, glm::dvec2 square) {
  using Shape = scene::Light::Shape;
  if (!(light.position.w > 0)) {
    throw InputError("shadow.samples: a light at infinity (w = 0) has no points; give it w = 1.");
  }
  const glm::dvec3 center = glm::dvec3(light.position) / light.position.w;
  const glm::dvec2 centred = 2.0 * square - 1.0;  // [-1, 1)²
  switch (light.shape) {
    case Shape::rectangle:
      return center + centred.x * light.half_u + centred.y * light.half_v;
    case Shape::disk: {
      // Each of the four triangles between the square's diagonals becomes a quarter of the disk:
      // squares around the centre become circles, and area is kept.
      if (centred.x == 0 && centred.y == 0) return center;
      const bool beside = std::abs(centred.x) > std::abs(centred.y);
      const double radius = beside ? centred.x : centred.y;
      const double angle =
          beside ? std::numbers::pi / 4 * (centred.y / centred.x)
                 : std::numbers::pi / 2 - std::numbers::pi / 4 * (centred.x / centred.y);
      return center + radius * std::cos(angle) * light.half_u +
             radius * std::sin(angle) * light.half_v;
    }
    case Shape::sphere: {
      const double height = centred.y;
      const double around = std::sqrt(std::max(0.0, 1 - height * height));
      const double longitude = 2 * std::numbers::pi * square.x;
      return center + light.radius * glm::dvec3(around * std::cos(longitude), height,
                                                around * std::sin(longitude));
    }
    case Shape::point:
      break;
  }
  return center;
}

std::vector<glm::dvec3> samples(const scene::Light& light, int n, Pattern pattern,
                                std::uint64_t seed) {
  std::vector<glm::dvec3> points;
  points.reserve(static_cast<std::size_t>(std::max(n, 0)));
  for (const glm::dvec2 square : unit_square_points(n, pattern, seed)) {
    points.push_back(point_on_light(light, square));
  }
  return points;
}

}  // namespace shadowlab::shadow
