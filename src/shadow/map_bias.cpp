#include "shadow/map_bias.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace shadowlab::shadow {

MapBias map_bias(const glm::dmat4& projection, double size, double filter) {
  if (!(size >= 1 && std::isfinite(size)))
    throw InputError("A shadow map has at least one texel; give its size in texels.");
  if (!(filter >= 1 && std::isfinite(filter)))
    throw InputError("A filter reads at least one texel across; 1 is the nearest alone.");
  // Rasterizers snap vertices to 1/256 of a texel (OpenGL's subpixel bits, at least 4; llvmpipe and
  // GPUs 8), so a plane is drawn up to 1/128 from its place over its own width.
  const double reach = filter / 2 + 1.0 / 64;
  const double texel =
      2 / (size * std::min(std::abs(projection[0][0]), std::abs(projection[1][1])));
  // The map rounds to 2^-24, by half a unit; the lookup's depth is a float near 1, of 2^-24 too,
  // after a matrix and a division: a few of them. Of a point light far from what it lights, whose
  // near plane is not far from the far one, a clip depth is the difference of numbers |m22| times
  // as large: a rounding of the matrix, of the product and of the sum, of either depth, each of
  // |m22| / 2.
  const bool perspective = projection[2][3] != 0;
  const double units = 4 + (perspective ? 3 * std::max(0.0, std::abs(projection[2][2]) - 1) : 0);
  return {2 * reach, units, std::sqrt(2.0) * reach * texel, texel, reach / size};
}

}  // namespace shadowlab::shadow
