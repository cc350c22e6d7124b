// A perspective projection whose far plane is at infinity.
#pragma once

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// Eye to clip space, depth to [-1, 1]: the limit of gluPerspective as far → ∞ (C. Everitt, M.
/// Kilgard, Practical and Robust Stenciled Shadow Volumes, 2002, equation 2). Depth of a point at
/// distance z before the eye is 1 - 2 near / z, and a point at infinity (w = 0) has clip z = clip
/// w: exactly depth 1, on the far plane and inside it, in float too, since both rows multiply
/// alike. So caps at infinity are never clipped. Against a finite projection this costs depth
/// resolution by only far / (far - near). The other way to keep caps is GL_DEPTH_CLAMP under the
/// finite projection: it clips at neither near nor far and clamps each fragment's depth to [0, 1]
/// instead, so that what lies past the far plane tests as if on it. Throws InputError unless 0 <
/// fovy_degrees < 180, aspect > 0, near > 0, all finite.
glm::dmat4 infinite_perspective(double fovy_degrees, double aspect, double near);

}  // namespace shadowlab::shadow
