#include "shadow/cascades.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "shadow/facing.h"

namespace shadowlab::shadow {
namespace {

struct Ball {
  double distance;  ///< of its centre along the view
  double radius;
};

// The smallest ball around a part of a symmetric frustum: its corners at near and at far are on two
// circles around the view, of radius k near and k far, k the tangent to a corner. The centre is as
// far from both, but no farther than the far circle's own.
Ball ball_around(double near, double far, double k) {
  const double distance = std::min(0.5 * (near + far) * (1 + k * k), far);
  const double to_far = std::hypot(far - distance, k * far);
  const double to_near = std::hypot(distance - near, k * near);
  return {distance, std::max(to_far, to_near)};
}

scene::Bounds bounds_of(const scene::Scene& scene) {
  scene::Bounds bounds;
  for (const scene::Object& object : scene.objects)
    bounds = scene::merge(bounds, scene::bounds(*object.mesh, object.model));
  return bounds;
}

LightView stable_view(const glm::dmat3& axes, glm::dvec3 center, double radius, int size,
                      const scene::Bounds& world) {
  // Relative to the world's middle, so that a world far from its origin loses nothing.
  const glm::dvec3 middle = world.center();
  const double half = radius * size / std::max(1, size - 1);  // half a texel's slack each side
  const double texel = 2 * half / size;
  const glm::dvec3 at = axes * (center - middle);
  const glm::dvec2 step = glm::round(glm::dvec2(at) / texel);
  const double depth = std::max(world.radius() * 1.001, 1e-6);
  LightView light{glm::dmat4(axes), glm::dmat4(1), -depth, depth};
  light.view[3] = glm::dvec4(-(axes * middle), 1);
  light.projection[0][0] = light.projection[1][1] = 1 / half;
  light.projection[2][2] = -1 / depth;
  // Whole texels: a translation by 2/size each, which is exact where size is a power of two.
  light.projection[3] = {-2 * step.x / size, -2 * step.y / size, 0, 1};
  return light;
}

}  // namespace

std::vector<double> split_distances(double near, double far, int count, double lambda) {
  if (!(near > 0 && far > near && std::isfinite(far)))
    throw InputError("Splits take 0 < near < far, both finite.");
  if (count < 1 || count > 64) throw InputError("A view is split into 1 to 64 parts.");
  if (!(lambda >= 0 && lambda <= 1))
    throw InputError("Lambda is from 0 (the uniform split) to 1 (the logarithmic one).");
  std::vector<double> distances;
  for (int i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    distances.push_back(lambda * near * std::pow(far / near, part) +
                        (1 - lambda) * (near + (far - near) * part));
  }
  distances.front() = near;
  distances.back() = far;
  return distances;
}

std::vector<Cascade> cascades(const scene::Scene& scene, const scene::Camera& camera, double aspect,
                              glm::dvec4 light, int count, DepthRange range,
                              const CascadeOptions& options) {
  const auto distances = split_distances(range.near, range.far, count, options.lambda);
  light = normalized_light(light);
  const bool tight = options.fit == CascadeOptions::Fit::tight;
  if (!tight && light.w != 0) {
    throw InputError(
        "Stable cascades keep their texels for a light at infinity (w = 0); a point light takes "
        "tight ones.");
  }
  if (options.size < 1) throw InputError("A shadow map has at least one texel.");
  camera.projection(aspect);
  const double tangent = std::tan(glm::radians(camera.fovy) / 2);
  const double k = tangent * std::hypot(1.0, aspect);
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const scene::Bounds world = bounds_of(scene);
  std::vector<Cascade> cascades;
  for (std::size_t i = 0; i + 1 < distances.size(); ++i) {
    const double near = distances[i], far = distances[i + 1];
    Cascade cascade{near, far, {}};
    if (tight) {
      cascade.light =
          light_view(light, scene, {visible_sides(scene, frustum(camera, aspect, near, far)), {}});
    } else {
      const Ball ball = options.fit == CascadeOptions::Fit::stable
                            ? ball_around(near, far, k)
                            : Ball{0, far * std::hypot(1.0, k)};
      cascade.light =
          stable_view(light_axes(glm::dvec3(light)), camera.eye + forward * ball.distance,
                      ball.radius, options.size, world);
    }
    cascades.push_back(cascade);
  }
  return cascades;
}

}  // namespace shadowlab::shadow
