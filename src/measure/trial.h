// A small world made at random, and what is simpler than it: what the search for departures tries.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace shadowlab::measure {

enum class Shape { box, tetrahedron, sphere, torus, teapot, sheet, sliver, count };

/// A caster: a shape of about unit size, turned, stretched and moved.
struct TrialCaster {
  Shape shape = Shape::box;
  glm::dvec3 place{0, 1, 0};
  glm::dvec3 axis{0, 1, 0};
  double degrees = 0;
  glm::dvec3 scale{1};
};

struct Trial {
  std::vector<TrialCaster> casters;
  scene::Camera camera;
  glm::dvec4 light{0};
  double unit = 1;       ///< the whole world is this large
  glm::dvec3 offset{0};  ///< and then moved, in such units
};

/// Trial number `index` of those that `seed` names: one to three casters over a floor. Half of them
/// have round numbers, so that faces lie in planes of each other, of the light and of the eye.
Trial trial_of(std::uint64_t seed, std::uint64_t index);

/// The scene, with the floor, its camera and its light.
scene::Scene scene_of(const Trial& trial);

/// Trials that are each a step simpler: a caster less, a simpler shape, rounder numbers, no offset.
/// The simplest first. Empty for what cannot be made simpler.
std::vector<Trial> simpler(const Trial& trial);

/// As a world of tests/given.lua, and the light: what a test is made of.
std::string lua_of(const Trial& trial);

}  // namespace shadowlab::measure
