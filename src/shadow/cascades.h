// Several maps for one view: cascades.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "shadow/light_view.h"

namespace shadowlab::shadow {

/// The distances n = z_0 < z_1 < … < z_count = f at which a view is split:
///
///   z_i = λ n (f/n)^(i/count) + (1 - λ) (n + (f - n) i/count),
///
/// λ = 0 the uniform split, λ = 1 the logarithmic one, under which every part has the same ratio of
/// far to near and so the same perspective aliasing (F. Zhang et al., Parallel-Split Shadow Maps
/// for Large-scale Virtual Environments, VRCIA 2006). z_0 and z_count are near and far exactly.
/// Throws InputError unless 0 < near < far, finite, count from 1 to 64, and λ in [0, 1].
std::vector<double> split_distances(double near, double far, int count, double lambda);

struct Cascade {
  double near, far;  ///< along the camera's view, metres
  LightView light;
};

struct CascadeOptions {
  enum class Fit {
    tight,   ///< to what is seen in each part, as `light_view`
    stable,  ///< to a ball around each part, in steps of a texel
    camera,  ///< to balls around the camera, each as far as its split, in steps of a texel
  };
  double lambda = 0.5;
  Fit fit = Fit::tight;
  int size = 1024;  ///< of each map, texels; stable maps step by these
};

/// Cascades of `camera`, for the distances from `range.near` to `range.far`.
///
/// Stable maps do not swim: their extent is a ball's diameter, which does not depend on where the
/// camera looks, and their centre moves in whole texels of axes that depend on the light alone; in
/// depth they reach over the whole scene. So a texel's picture of a still caster stays the same
/// until its texel leaves the map (M. Valient, Stable Rendering of Cascaded Shadow Maps, ShaderX6,
/// 2008). They need a light at infinity: InputError for a point light; also as `light_view` and
/// `split_distances`, and for a size under 1.
std::vector<Cascade> cascades(const scene::Scene& scene, const scene::Camera& camera, double aspect,
                              glm::dvec4 light, int count, DepthRange range,
                              const CascadeOptions& options);

}  // namespace shadowlab::shadow
