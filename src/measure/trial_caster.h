// What casts shadows in a random world: a shape, broken in one way or whole, turned, stretched,
// moved.
#pragma once

#include <string>

#include "measure/random.h"
#include "scene/mesh.h"

namespace shadowlab::measure {

enum class Shape { box, tetrahedron, sphere, torus, teapot, sheet, sliver, count };

/// How a mesh is not as it should be.
enum class Damage {
  none,
  twice,     ///< each triangle twice
  reversed,  ///< all triangles run the other way
  mixed,     ///< every second triangle does
  opened,    ///< every third triangle is missing
  split,     ///< every second triangle in two, whose neighbours know nothing of it: T-junctions
  finned,    ///< on each third triangle's edge one more, in its plane: three at an edge
  needles,   ///< with triangles of no area
  count
};

/// A caster: a shape of about unit size, turned, stretched and moved. A negative scale mirrors it.
struct TrialCaster {
  Shape shape = Shape::box;
  Damage damage = Damage::none;
  glm::dvec3 place{0, 1, 0};
  glm::dvec3 axis{0, 1, 0};
  double degrees = 0;
  glm::dvec3 scale{1};
};

scene::Mesh mesh_of(const TrialCaster& caster);
/// From the mesh to the trial's units.
glm::dmat4 model_of(const TrialCaster& caster);

/// Of numbers that are multiples of simple ones, where `round`.
TrialCaster caster_of(Random& random, bool round);

/// The nearest multiple of `step`, a binary fraction wherever sums are to be exact.
double rounded(double value, double step);
glm::dvec3 rounded(glm::dvec3 v, double step);

/// As tests/found.lua reads it.
std::string lua_of(const TrialCaster& caster);
std::string lua_of(glm::dvec3 v);

}  // namespace shadowlab::measure
