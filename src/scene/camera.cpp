#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "scene/scene.h"

namespace shadowlab::scene {

glm::dmat4 Camera::view() const {
  const glm::dvec3 forward = target - eye;
  const double distance = glm::length(forward);
  if (!std::isfinite(distance) || !std::isfinite(glm::length(up))) {
    throw InputError("The camera's eye, target and up must be finite numbers.");
  }
  if (!(distance > 0.0)) {
    throw InputError("The camera's eye and target are the same point; move one of them.");
  }
  // The sine of the angle between up and the view: below this the roll is rounding.
  if (!(glm::length(glm::cross(forward, up)) > 1e-9 * distance * glm::length(up))) {
    throw InputError("The camera's up is zero or along its view; turn one of them.");
  }
  return glm::lookAt(eye, target, up);
}

glm::dmat4 Camera::projection(double aspect) const {
  if (!(fovy > 0.0 && fovy < 180.0)) {
    throw InputError(fmt::format(
        "The camera's field of view is {} degrees; it must be between 0 and 180.", fovy));
  }
  if (!(near > 0.0 && far > near && std::isfinite(far))) {
    throw InputError(fmt::format(
        "The camera's near is {} and far {}; it takes 0 < near < far, both finite.", near, far));
  }
  if (!(aspect > 0.0 && std::isfinite(aspect))) {
    throw InputError(fmt::format("The picture's aspect is {}; it must be positive.", aspect));
  }
  return glm::perspective(glm::radians(fovy), aspect, near, far);
}

}  // namespace shadowlab::scene
