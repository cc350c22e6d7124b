// A small world made at random, and what is simpler than it: what the search for departures tries.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/trial_caster.h"
#include "scene/scene.h"

namespace shadowlab::measure {

struct Trial {
  std::vector<TrialCaster> casters;
  scene::Camera camera;
  glm::dvec4 light{0};
  double unit = 1;       ///< the whole world is this large
  glm::dvec3 offset{0};  ///< and then moved, in such units
  int width = 64, height = 64;
  /// Of the values that a recipe's `sweep` lists, the one at this part of them: maps from the least
  /// to the largest size. Absent: the recipe's own.
  std::optional<double> swept;
};

/// Trial number `index` of those that `seed` names: one to three casters over a floor. Half of them
/// have round numbers, so that faces lie in planes of each other, of the light and of the eye; and
/// each has now and then what is hard: a broken mesh, a camera or a light in or on a caster, a
/// depth range of ten decades, a view of 1 or 170 degrees, a world of a ten-thousandth or of a
/// million, or a million units away.
Trial trial_of(std::uint64_t seed, std::uint64_t index);

/// The scene, with the floor, its camera and its light.
scene::Scene scene_of(const Trial& trial);

/// Trials that are each a step simpler: a caster less, a simpler shape, rounder numbers, no offset.
/// The simplest first. Empty for what cannot be made simpler.
std::vector<Trial> simpler(const Trial& trial);

/// As a world of tests/found.lua: what a test is made of.
std::string lua_of(const Trial& trial);

}  // namespace shadowlab::measure
