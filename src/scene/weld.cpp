#include "scene/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace shadowlab::scene {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::size_t mixed(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  std::uint64_t h = x * 0x9e3779b97f4a7c15u ^ std::rotl(y * 0xc2b2ae3d27d4eb4fu, 23) ^
                    std::rotl(z * 0x165667b19e3779f9u, 43);
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
  return h ^ (h >> 32);
}

std::size_t table_size(std::size_t count) { return std::bit_ceil(count * 2 + 16); }

WeldedVertices weld_equal(std::span<const glm::vec3> positions) {
  WeldedVertices welded;
  welded.positions.reserve(positions.size());
  welded.vertex_of.reserve(positions.size());
  const std::size_t mask = table_size(positions.size()) - 1;
  std::vector<std::uint32_t> table(mask + 1, none);
  const auto slot_of = [mask](const glm::vec3& p) {
    // Adding zero turns -0 into +0.
    return mixed(std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
                 std::bit_cast<std::uint32_t>(p.z + 0.0f)) &
           mask;
  };
  // The table is larger than the cache and its slots are random: so they are asked for some
  // vertices ahead of their use.
  constexpr std::size_t ahead = 16;
  std::array<std::size_t, ahead> slots{};
  for (std::size_t i = 0; i < positions.size() + ahead; ++i) {
    if (i >= ahead) {
      const glm::vec3& p = positions[i - ahead];
      std::size_t slot = slots[i % ahead];
      while (table[slot] != none && welded.positions[table[slot]] != p) slot = (slot + 1) & mask;
      if (table[slot] == none) {
        table[slot] = static_cast<std::uint32_t>(welded.positions.size());
        welded.positions.push_back(p);
      }
      welded.vertex_of.push_back(table[slot]);
    }
    if (i < positions.size()) {
      slots[i % ahead] = slot_of(positions[i]);
      __builtin_prefetch(&table[slots[i % ahead]], 1);
    }
  }
  return welded;
}

/// Kept vertices in cells as wide as the tolerance, so that only 27 cells can hold a near one.
class Cells {
 public:
  Cells(std::size_t count, double tolerance)
      : mask_(table_size(count) - 1), head_(mask_ + 1, none), tolerance_(tolerance) {}

  std::uint32_t earliest_near(glm::vec3 p, const std::vector<glm::vec3>& kept) const {
    std::uint32_t earliest = none;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const glm::dvec3 offset(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1);
      for (std::uint32_t i = head_[slot(p, offset)]; i != none; i = following_[i]) {
        const glm::dvec3 apart = glm::dvec3(kept[i]) - glm::dvec3(p);
        if (glm::dot(apart, apart) <= tolerance_ * tolerance_) earliest = std::min(earliest, i);
      }
    }
    return earliest;
  }

  /// `p` as the next kept vertex.
  void keep(glm::vec3 p) {
    std::uint32_t& head = head_[slot(p, glm::dvec3(0))];
    following_.push_back(head);
    head = static_cast<std::uint32_t>(following_.size() - 1);
  }

 private:
  std::size_t slot(glm::vec3 p, glm::dvec3 offset) const {
    const glm::dvec3 cell = glm::floor(glm::dvec3(p) / tolerance_) + offset;
    const auto key = [](double v) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
    };
    return mixed(key(cell.x), key(cell.y), key(cell.z)) & mask_;
  }

  std::size_t mask_;
  std::vector<std::uint32_t> head_;
  std::vector<std::uint32_t> following_;
  double tolerance_;
};

WeldedVertices weld_near(std::span<const glm::vec3> positions, double tolerance) {
  WeldedVertices welded;
  welded.vertex_of.reserve(positions.size());
  Cells cells(positions.size(), tolerance);
  for (const glm::vec3& p : positions) {
    std::uint32_t vertex = cells.earliest_near(p, welded.positions);
    if (vertex == none) {
      vertex = static_cast<std::uint32_t>(welded.positions.size());
      welded.positions.push_back(p);
      cells.keep(p);
    }
    welded.vertex_of.push_back(vertex);
  }
  return welded;
}

}  // namespace

WeldedVertices weld(std::span<const glm::vec3> positions, Weld weld) {
  if (weld.tolerance == 0) return weld_equal(positions);
  double largest = 0;
  for (const glm::vec3& p : positions) {
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(static_cast<double>(p[i])));
  }
  // So that a cell's number is a whole number that a double holds exactly.
  if (!std::isfinite(weld.tolerance) || weld.tolerance < largest * 0x1p-40 ||
      weld.tolerance < 1e-100) {
    throw InputError(
        "The tolerance for welding vertices is negative or too small for the mesh; use 0 to join "
        "equal vertices only, or a distance in metres.");
  }
  return weld_near(positions, weld.tolerance);
}

}  // namespace shadowlab::scene
