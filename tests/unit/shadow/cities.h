// Scenes of boxes, in which who shadows whom is a few comparisons.
#pragma once

#include <algorithm>
#include <memory>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {

inline scene::Object box_at(glm::dvec3 at, glm::dvec3 size) {
  static const auto unit_box = std::make_shared<const scene::Mesh>(scene::box());
  scene::Object object;
  object.mesh = unit_box;
  object.model = glm::scale(glm::translate(glm::dmat4(1), at), size);
  return object;
}

/// Boxes at random, a camera and a light among them.
struct City {
  scene::Scene scene;
  scene::Camera camera;
  glm::dvec4 light;
};

inline City random_city(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto point = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  City city;
  for (int i = 0; i < 8; ++i)
    city.scene.objects.push_back(box_at(point() * 4.0, glm::abs(point()) + 0.05));
  city.camera.eye = point() * 4.0;
  city.camera.target = city.camera.eye + point();
  city.camera.fovy = 20 + static_cast<double>(random() % 80);
  city.light = {point() * 5.0, random() % 3 == 0 ? 0.0 : 1.0};
  return city;
}

/// Whether the way from `p` to the light meets the box.
inline bool meets(const scene::Object& box, glm::dvec3 p, glm::dvec4 light) {
  const glm::dmat4 to_model = glm::inverse(box.model);
  const glm::dvec3 from(to_model * glm::dvec4(p, 1));
  const glm::dvec4 end = to_model * light;
  const glm::dvec3 way = light.w == 0 ? glm::dvec3(end) : glm::dvec3(end) - from;
  double in = 0, out = light.w == 0 ? 1e300 : 1;
  for (int i = 0; i < 3; ++i) {
    const double a = (-0.5 - from[i]) / way[i], b = (0.5 - from[i]) / way[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out;
}

}  // namespace shadowlab::shadow
