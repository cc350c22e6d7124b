// Points on an area light: the patterns, and the maps from the unit square to each shape of light.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {

/// How N points are spread over the unit square.
///   random      independent and uniform: error N^-1/2.
///   jitter      one point at random in each of N cells of equal area.
///   grid        the centres of those cells. Best on slanted edges, worst on axis-aligned ones.
///   hammersley  ((i + 1/2)/N, radical inverse of i in base 2 + 1/2 of its step), both centred: at
///               N = 16 the inverse alone has the light a 16th of its half-width off its place.
///   r2          Roberts' additive recurrence on the plastic number.
///   sobol       the first two dimensions of Sobol's sequence, a (0, 2)-sequence in base 2.
///   owen        Sobol's sequence under Owen's nested uniform scrambling.
enum class Pattern { random, jitter, grid, hammersley, r2, sobol, owen };

/// The names of the patterns, in the order of the enumeration.
std::span<const std::string_view> pattern_names();
/// The pattern of that name, or nothing.
std::optional<Pattern> pattern_named(std::string_view name);

/// Whether the first n points of a longer set are the set of n: what adaptive sampling needs. True
/// for random, r2, sobol and owen.
bool is_nested(Pattern pattern);

/// Whether the seed matters: random, jitter and owen. The others are one fixed set for each n.
bool is_seeded(Pattern pattern);

/// `n` ≥ 1 points in [0, 1)². The same arguments give the same points on every machine. Throws
/// InputError for n < 1 or n > 2^24.
std::vector<glm::dvec2> unit_square_points(int n, Pattern pattern, std::uint64_t seed);

/// Point `index` of the Owen-scrambled Sobol sequence: unit_square_points(n, owen, seed)[index] for
/// every n > index.
glm::dvec2 owen_point(std::uint32_t index, std::uint64_t seed);

/// The point of `light` (world space) that `square` in [0, 1)² maps to; equal areas map to equal
/// areas.
///   rectangle  center + (2u-1) half_u + (2v-1) half_v
///   disk       the concentric map of Shirley and Chiu 1997 onto the ellipse of those half-axes
///   sphere     uniform over the whole surface (Archimedes: height and longitude uniform). The far
///              side counts too: the points do not depend on who is lit, so one set serves every
///              receiver, and a sphere is transparent to its own light. Seen from afar the density
///              grows toward the rim of the disk, and a half-plane's shadow is a linear ramp.
///   point      the position. Throws InputError for an area light at infinity (w = 0) or a w < 0.
glm::dvec3 point_on_light(const scene::Light& light, glm::dvec2 square);

/// `n` points on `light` in world space: point_on_light of unit_square_points. A point light gives
/// n times its position; a light at infinity throws InputError, as it has no points.
std::vector<glm::dvec3> samples(const scene::Light& light, int n, Pattern pattern,
                                std::uint64_t seed = 0);

}  // namespace shadowlab::shadow
