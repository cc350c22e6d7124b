// How a hand moves a camera: around what it looks at, nearer and farther, to the side.
#pragma once

#include "scene/scene.h"

namespace shadowlab::live {

/// Around the target by `across` about the camera's up vector and `over` above it, degrees; up
/// stays up: the eye stops a degree from straight above and below.
scene::Camera orbited(const scene::Camera& camera, double across, double over);

/// At `factor` of the distance from the target; the far plane keeps what it held.
scene::Camera approached(const scene::Camera& camera, double factor);

/// Eye and target to the side by so many pictures' heights at the target's distance.
scene::Camera shifted(const scene::Camera& camera, double right, double up);

/// The ray from the eye through a place of the picture: x from -1 (left) to 1, y from -1 (bottom)
/// to 1. Its direction has length 1.
struct Ray {
  glm::dvec3 origin, direction;
};
Ray ray_through(const scene::Camera& camera, double aspect, double x, double y);

/// Where a point of the world is in the picture, x and y as above, and its distance along the view;
/// the place means nothing where that is not positive.
struct Seen {
  double x, y, distance;
};
Seen seen(const scene::Camera& camera, double aspect, glm::dvec3 point);

}  // namespace shadowlab::live
