#include "shadow/infinite_perspective.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "core/error.h"

namespace shadowlab::shadow {

glm::dmat4 infinite_perspective(double fovy_degrees, double aspect, double near) {
  if (!(fovy_degrees > 0 && fovy_degrees < 180)) {
    throw InputError("The field of view must be between 0 and 180 degrees.");
  }
  if (!(aspect > 0 && std::isfinite(aspect))) {
    throw InputError("The aspect, width / height, must be more than 0.");
  }
  if (!(near > 0 && std::isfinite(near))) {
    throw InputError("The near plane's distance must be more than 0.");
  }
  const double cotangent = 1 / std::tan(glm::radians(fovy_degrees) / 2);
  glm::dmat4 projection(0.0);
  projection[0][0] = cotangent / aspect;
  projection[1][1] = cotangent;
  projection[2][2] = -1;
  projection[2][3] = -1;
  projection[3][2] = -2 * near;
  return projection;
}

}  // namespace shadowlab::shadow
