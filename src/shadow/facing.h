// Which triangles face the light, exactly, for a light that moves every frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/adjacency.h"

namespace shadowlab::shadow {

/// A light is (x, y, z, w) in model space: w = 1 a point, w = 0 the direction toward a light at
/// infinity, any w > 0 the point xyz/w. This is the same light with w ≥ 0. Throws InputError where
/// it is not finite or where xyz = 0 and w = 0.
glm::dvec4 normalized_light(glm::dvec4 light);

/// The light in the space of an object: inverse(model)·light, normalized. Throws InputError where
/// `model` is not invertible.
glm::dvec4 light_in_model_space(const glm::dmat4& model, glm::dvec4 light);

/// The planes of a mesh's triangles, as floats with a proven error bound; where that cannot tell,
/// the vertices decide exactly (`scene::plane_side`). So the answers do not depend on the machine.
class FacingPlanes {
 public:
  FacingPlanes(std::vector<glm::vec3> positions, std::vector<scene::Triangle> triangles);

  std::span<const glm::vec3> positions() const { return positions_; }
  std::span<const scene::Triangle> triangles() const { return triangles_; }

  /// out[i] for triangle first + i: 1 where it faces `light` (normalized), 0 where it faces away or
  /// holds the light in its plane.
  void lit(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out) const;
  /// out[i] for triangle first + i: +1, -1, or 0 where the light is in its plane.
  void signs(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out) const;

  /// `light` (normalized), moved off the triangles that it lies on: to 2^-17 of the mesh's radius
  /// from them, toward the side that it is on; but not off one whose plane it is in exactly.
  /// Nearer, floats do not tell the three directions to such a triangle's corners from directions
  /// in one plane, so that its shadow, half of all there is, is lost. Costs nothing where the light
  /// is outside of the mesh's ball.
  glm::dvec4 beside(glm::dvec4 light) const;

  /// A light in the planes' units, rounded: plane(i)·light is over `bound` where triangle i faces
  /// it, under -bound where it faces away, in float and in whatever order the products are added.
  /// Between the two the planes cannot tell.
  struct ScaledLight {
    glm::vec4 light;
    float bound;
  };
  /// `light` is normalized.
  ScaledLight scaled(glm::dvec4 light) const;
  /// The plane of triangle i for a shader; 0 where it is such a sliver that floats say nothing.
  glm::vec4 plane(std::size_t i) const { return {x_[i], y_[i], z_[i], d_[i]}; }

  /// Bytes that `lit` must read a triangle.
  static constexpr std::size_t bytes_a_triangle = 4 * sizeof(float);

 private:
  std::vector<glm::vec3> positions_;
  std::vector<scene::Triangle> triangles_;
  std::vector<float> x_, y_, z_, d_;  // unit normals n, and n·(center_ - a) / radius_
  glm::dvec3 center_{0};
  double radius_ = 1;      // of a ball around center_ that holds all vertices
  double coordinate_ = 0;  // no vertex has a greater one

  /// Where the light at `p` is beside triangle t; nothing where that is not too near.
  std::optional<glm::dvec3> beside(std::size_t t, glm::dvec3 p) const;
  template <class Sign>
  void decide(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out, Sign sign) const;
};

}  // namespace shadowlab::shadow
