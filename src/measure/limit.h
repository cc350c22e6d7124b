// How far a technique may depart from the truth, and whether a pixel departs farther.
//
// A limit is of places, not of brightness: a pixel is within it where the truth of some place that
// the technique may have taken for the pixel's own is what it drew.
#pragma once

#include <memory>

#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab::measure {

struct LitScene;

/// Whether the light is in the plane of what is seen. There lit and dark are a tie, which each
/// technique decides as it likes, and Lambert's cosine is 0: nobody sees which.
bool grazed(const truth::Surface& surface, glm::dvec4 light);

/// What the techniques may do in one scene, under its first light. Keeps a reference to both.
class Limits {
 public:
  /// `rows` of pixels are in the picture.
  Limits(const scene::Scene& scene, const truth::Tracer& tracer, const recipe::Limit& limit,
         int rows);
  ~Limits();

  /// Whether `lit` can be rightly drawn at a surface of the scene's own view whose truth is the
  /// opposite:
  ///  - another surface is so near behind this one that the depth buffer cannot tell them apart,
  ///    and is what was drawn;
  ///  - an edge of a caster is within 1/128 of a pixel, as the eye or as the light sees it;
  ///  - the light is so near to a surface that a float does not tell which side it is on;
  ///  - along the sight, by the error of the depth that the technique counts against: toward the
  ///    eye, and on receivers away from it; where two sides of volumes are so near, either may have
  ///    been counted without the other;
  ///  - a side of a caster's volume is seen edge on, within 1/128 of a pixel;
  ///  - across the light's rays, where an edge of a caster is within a map's texels and filter;
  ///  - on the surface itself, within what its own texture's filter reads;
  ///  - toward the light, by the offset that keeps a map's surfaces from shadowing themselves,
  ///    which grows with the slopes of the caster and of the surface, and by 2^-20 of the distance
  ///    from the eye, by which floats tell a place.
  bool allow(const truth::Surface& surface, bool lit) const;

  /// Whether a caster may be drawn in place of `surface`: it is there too, or so near behind it
  /// that depth cannot tell them apart.
  bool allow_a_caster(const truth::Surface& surface) const;

 private:
  std::unique_ptr<LitScene> scene_;
};

/// How many pixels of `drawn` are on the wrong side of the truth, at none of its edges, and beyond
/// `limit`. All pictures are of the scene's own view.
std::size_t beyond_limit(const scene::Scene& scene, const truth::Tracer& tracer,
                         const recipe::Limit& limit, const image::FloatImage& drawn,
                         const image::FloatImage& truth, const image::FloatImage& edges,
                         const truth::SurfaceImage& surfaces);

}  // namespace shadowlab::measure
