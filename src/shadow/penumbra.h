// How many points of a light a picture needs: from its penumbra, and from what points already say.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace shadowlab::shadow {

/// What of a picture lies between light and dark.
struct Penumbra {
  double width = 0;   ///< across, in pixels: the mean along its length
  double pixels = 0;  ///< its area, never more than the picture's
  double share = 0;   ///< of the picture
};

/// The penumbra that `light` leaves on the scene's receivers as `camera` sees them in a picture of
/// that many pixels: along each silhouette edge of each caster, seen from the light's centre, the
/// strip that the edge's shadow sweeps while the light moves across itself. A receiver that is not
/// planar stands for the faces of its box. An estimate: what hides a strip, and where strips lie
/// over each other, it does not know; nor what casters throw on themselves. Nothing for a point or
/// a light at infinity. Throws InputError as Camera::view, and where a model matrix is singular.
Penumbra penumbra(const scene::Scene& scene, const scene::Camera& camera, const scene::Light& light,
                  glm::ivec2 picture);

/// The RMSE of visibility over a picture with that penumbra, for `points` of Owen's pattern: 0.3
/// N^-3/4 inside of it (what they have on edges; samples_test.cpp), none elsewhere.
double expected_error(const Penumbra& penumbra, int points);

/// The least power of two, from 1 to 65536, with at most `error` > 0 expected.
int points_for(const Penumbra& penumbra, double error);

/// The error of a mean over N points, of which the means of the first and of the second half differ
/// by `difference` (a root mean square over the picture). For independent points it is half the
/// difference, on average; for points whose error falls as N^-s, 1/(2 √(4^s - 1)) of it, which is
/// less for s > 1/2: so half of it is not too little for them. It is
/// an estimate for points at random, as Owen's are: what both halves of a fixed set have in common,
/// as that Sobol's are off the middle, their difference cannot show.
double error_of_halves(double difference);

}  // namespace shadowlab::shadow
