// Small scenes for the tests of the tracer.
#pragma once

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.h"

namespace shadowlab::truth {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline glm::dvec3 point_in(Random& random, glm::dvec3 low, glm::dvec3 high) {
  return {uniform(random, low.x, high.x), uniform(random, low.y, high.y),
          uniform(random, low.z, high.z)};
}

inline scene::Object object(scene::Mesh mesh, scene::Role role, glm::dvec3 at = glm::dvec3(0)) {
  scene::Object result;
  result.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
  result.model = glm::translate(glm::dmat4(1), at);
  result.role = role;
  return result;
}

inline scene::Light point_light(glm::dvec3 at) { return {.position = {at, 1}}; }

inline scene::Object floor_object(double size = 20) {
  return object(scene::plane(size, size), scene::Role::receiver);
}

/// An axis-aligned rectangle at height h that spans [low, high] in (x, z).
inline scene::Object slab(double h, glm::dvec2 low, glm::dvec2 high) {
  scene::Mesh mesh;
  const auto corner = [&](double x, double z) { mesh.positions.emplace_back(x, h, z); };
  corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y);
  mesh.indices = {0, 2, 1, 0, 3, 2};
  return object(std::move(mesh), scene::Role::caster);
}

/// Straight down from height 1000 with a narrow view: pixel centres of a w × w picture are known
/// points of the floor, x = (i + 1/2) step - width/2 and z alike, rows from the top along +z.
inline scene::Camera above(double width) {
  return {.eye = {0, 1000, 0},
          .target = {0, 0, 0},
          .up = {0, 0, -1},
          .fovy = 2 * glm::degrees(std::atan(width / 2 / 1000)),
          .near = 990,
          .far = 1001};
}

/// A floor with a few turned shapes on and over it, closed and open ones, touching and piercing.
inline scene::Scene clutter(Random& random) {
  scene::Scene scene;
  scene.objects.push_back(floor_object());
  const auto add = [&](scene::Mesh mesh, scene::Role role) {
    scene::Object added = object(std::move(mesh), role, point_in(random, {-2, 0.2, -2}, {2, 2, 2}));
    added.model = glm::rotate(added.model, uniform(random, 0, 6.28),
                              glm::normalize(point_in(random, {-1, -1, -1}, {1, 1, 1})));
    scene.objects.push_back(std::move(added));
  };
  add(scene::box(), scene::Role::both);
  add(scene::tetrahedron(0.8), scene::Role::both);
  add(scene::sphere(0.6, 8, 5), scene::Role::both);
  add(scene::torus(0.6, 0.25, 10, 6), scene::Role::both);
  add(scene::plane(1.5, 1), scene::Role::both);
  scene.objects.push_back(
      object(scene::box(), scene::Role::both, {0.3, 0.5, -0.4}));  // on the floor
  return scene;
}

}  // namespace shadowlab::truth
