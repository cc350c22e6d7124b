// How often a ray along an axis crosses triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// How often the ray from `from` along +`axis` (0, 1 or 2) leaves triangles by the side that sees
/// them counter-clockwise, less how often by the other; nothing where it passes an edge or a
/// triangle begins so near to `from` that rounding could tell it wrong. `triangles` are indices
/// into `vertices`, three each.
std::optional<int> crossings(std::span<const glm::vec4> vertices,
                             std::span<const std::uint32_t> triangles, glm::dvec3 from, int axis);

}  // namespace shadowlab::shadow
