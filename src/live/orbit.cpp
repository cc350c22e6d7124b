#include "live/orbit.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace shadowlab::live {
namespace {

constexpr double nearest_to_a_pole = 1.0;  // degree
constexpr double nearest_distance = 1e-3, farthest_distance = 1e6;

struct Axes {
  glm::dvec3 right, up, back;
};

Axes axes_of(const scene::Camera& camera) {
  const glm::dvec3 back = glm::normalize(camera.eye - camera.target);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
  return {right, glm::cross(back, right), back};
}

double tangent(const scene::Camera& camera) { return std::tan(glm::radians(camera.fovy) / 2); }

}  // namespace

scene::Camera orbited(const scene::Camera& camera, double across, double over) {
  const glm::dvec3 pole = glm::normalize(camera.up);
  const glm::dvec3 arm = camera.eye - camera.target;
  const double length = glm::length(arm);
  const double height =
      glm::degrees(std::asin(std::clamp(glm::dot(arm, pole) / length, -1.0, 1.0)));
  const double most = 90 - nearest_to_a_pole;
  const double wanted = std::clamp(height + over, std::min(-most, height), std::max(most, height));
  const glm::dvec3 right = axes_of(camera).right;
  glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(-across), pole);
  turn = glm::rotate(turn, glm::radians(height - wanted), right);
  scene::Camera moved = camera;
  moved.eye = camera.target + glm::dvec3(turn * glm::dvec4(arm, 0));
  return moved;
}

scene::Camera approached(const scene::Camera& camera, double factor) {
  const glm::dvec3 arm = camera.eye - camera.target;
  const double before = glm::length(arm);
  const double after = std::clamp(before * factor, nearest_distance, farthest_distance);
  scene::Camera moved = camera;
  moved.eye = camera.target + arm * (after / before);
  moved.far = std::max(camera.far, camera.far + after - before);
  return moved;
}

scene::Camera shifted(const scene::Camera& camera, double right, double up) {
  const Axes axes = axes_of(camera);
  const double height = 2 * tangent(camera) * glm::length(camera.eye - camera.target);
  const glm::dvec3 step = axes.right * (right * height) + axes.up * (up * height);
  scene::Camera moved = camera;
  moved.eye += step;
  moved.target += step;
  return moved;
}

Ray ray_through(const scene::Camera& camera, double aspect, double x, double y) {
  const Axes axes = axes_of(camera);
  const double height = tangent(camera);
  return {camera.eye,
          glm::normalize(axes.right * (x * height * aspect) + axes.up * (y * height) - axes.back)};
}

Seen seen(const scene::Camera& camera, double aspect, glm::dvec3 point) {
  const Axes axes = axes_of(camera);
  const glm::dvec3 arm = point - camera.eye;
  const double distance = -glm::dot(arm, axes.back);
  const double height = tangent(camera) * distance;
  return {glm::dot(arm, axes.right) / (height * aspect), glm::dot(arm, axes.up) / height, distance};
}

}  // namespace shadowlab::live
