// A scene: objects with roles, a camera, lights. Plain values; no GL, no Lua.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace shadowlab::scene {

enum class Role { caster, receiver, both };

struct Material {
  glm::dvec3 color{0.8};
};

struct Object {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  glm::dmat4 model{1.0};  ///< model space to world space
  Material material;
  Role role = Role::both;

  bool casts() const { return role != Role::receiver; }
  bool receives() const { return role != Role::caster; }
};

/// A perspective camera in world space, right-handed, looking down its own -z.
struct Camera {
  glm::dvec3 eye{0, 2, 6};
  glm::dvec3 target{0};
  glm::dvec3 up{0, 1, 0};
  double fovy = 45.0;  ///< vertical field of view, degrees
  double near = 0.1;   ///< metres, > 0
  double far = 100.0;  ///< metres, > near

  /// World to eye space. Throws InputError where eye = target or up is along the view.
  glm::dmat4 view() const;
  /// Eye to clip space, depth to [-1, 1]; `aspect` is width / height.
  glm::dmat4 projection(double aspect) const;
};

/// A light. `position` is homogeneous, world space: w = 1 a point, w = 0 the direction toward a
/// light at infinity. An area light is a rectangle (center ± half_u ± half_v), an ellipse with
/// those half-axes (disk), or a sphere of `radius`, around `position`.
struct Light {
  enum class Shape { point, rectangle, disk, sphere };
  glm::dvec4 position{0, 4, 0, 1};
  Shape shape = Shape::point;
  glm::dvec3 half_u{0};
  glm::dvec3 half_v{0};
  double radius = 0;
};

struct Scene {
  std::string name;
  std::string title;
  std::vector<Object> objects;
  Camera camera;
  std::vector<Light> lights;
};

}  // namespace shadowlab::scene
