// Sines and cosines of angles in degrees, exact where they are 0, 1/2 or 1 and equal at 45 degrees:
// a quarter turn prints as zeros and ones instead of 6.1e-17, and the cotangent of 45 degrees is 1.
#pragma once

#include <cmath>
#include <numbers>

namespace shadowlab::lua {

struct SineCosine {
  double sine, cosine;
};

inline SineCosine sine_cosine(double degrees) {
  int quarter = 0;
  const double rest = std::remquo(degrees, 90.0, &quarter);  // exact, within 45 degrees of 0
  const double radians = rest * std::numbers::pi / 180.0;
  double s = std::sin(radians), c = std::cos(radians);
  if (std::fabs(rest) == 30) s = std::copysign(0.5, rest);
  if (std::fabs(rest) == 45) s = std::copysign(c = std::sqrt(0.5), rest);
  switch (static_cast<unsigned>(quarter) % 4) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace shadowlab::lua
