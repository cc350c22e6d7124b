// How far a depth map must be biased so that no lit surface shadows itself, and no farther.
#pragma once

#include <glm/glm.hpp>

namespace shadowlab::shadow {

/// Where the numbers come from. A fragment compares its depth with a texel that stores the depth of
/// the same plane at another place, up to `reach` texels away in x and in y: half a texel for the
/// nearest texel, half the filter's width in general. Over that way the plane's depth changes by at
/// most
///
///   reach · (|∂z/∂x| + |∂z/∂y|)  <=  2 reach · m,    m = max(|∂z/∂x|, |∂z/∂y|) a texel,
///
/// so glPolygonOffset(2 reach, units) while the map is drawn lifts every texel's depth past every
/// lit fragment of its plane that it is compared with (OpenGL 4.5, section 14.6.5, equation 14.13,
/// whose m this is). `units` covers what rounding does to either depth. Where the texel's centre is
/// on another plane than the fragment, beyond a rim, that lifts by the other's slope; so the
/// fragment takes off its own climb as well, reach · (|∂z/∂s| + |∂z/∂t|)
/// (shaders/receiver_plane.glsl).
///
/// In the world the same is a move of the receiver along its normal: a plane turned by θ from the
/// light has slope tan θ, the farthest way over a texel is √2 reach, and a step δ along the normal
/// gains δ / cos θ toward the light, so
///
///   δ = √2 · reach · texel · sin θ
///
/// (normal offset: D. Holbert, Saying "Goodbye" to Shadow Acne, GDC 2011; slope-scaled bias: the
/// formula above). So a contact's gap is at most √2 · reach · texel.
struct MapBias {
  double factor;         ///< of glPolygonOffset
  double units;          ///< of glPolygonOffset
  double normal_offset;  ///< times sin θ: metres, or metres a metre along the axis of a perspective
  double texel;          ///< a texel's side in the same unit
  double reach;          ///< of a lookup, over the map's side
};

/// For a square map of `size` texels drawn with `projection` (a LightView's), looked up by a filter
/// that reads `filter` texels across: 1 the nearest, 2 the hardware's 2 × 2, n + 1 for n × n of
/// those. The wider of the map's two directions counts. Throws InputError for a size or filter
/// under 1.
MapBias map_bias(const glm::dmat4& projection, double size, double filter);

}  // namespace shadowlab::shadow
