#include "scene/exact_sign.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace shadowlab::scene {
namespace {

// Half an ulp of 1.
constexpr double unit_roundoff = 0x1p-53;
// Below this a product may have lost bits to underflow, so that relative bounds mean nothing.
constexpr double smallest_trusted = 1e-200;

/// A number as mantissa * 2^exponent with an integer mantissa.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

Parts split(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

/// Of a float, so that three of them and a double multiply to less than 125 bits.
Parts split(float value) {
  int exponent = 0;
  const float fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 24)), exponent - 24};
}

/// A sum of integers times powers of two, without rounding: fixed point over the whole range of a
/// product of three floats and a double. Limbs are signed and carry only at the end.
class ExactSum {
 public:
  void add(__int128 mantissa, int exponent) {
    if (mantissa == 0) return;
    const std::int64_t sign = mantissa < 0 ? -1 : 1;
    auto rest = static_cast<unsigned __int128>(mantissa < 0 ? -mantissa : mantissa);
    const auto shift = static_cast<unsigned>(exponent + lowest_exponent);
    std::size_t limb = shift / 32;
    const unsigned offset = shift % 32;
    limbs_[limb++] += sign * static_cast<std::int64_t>(static_cast<std::uint32_t>(rest << offset));
    rest >>= 32 - offset;
    for (; rest != 0; rest >>= 32) {
      limbs_[limb++] += sign * static_cast<std::int64_t>(static_cast<std::uint32_t>(rest));
    }
  }

  int sign() const {
    std::int64_t carry = 0;
    bool nonzero = false;
    for (const std::int64_t limb : limbs_) {
      const std::int64_t total = limb + carry;
      nonzero = nonzero || (total & 0xffffffff) != 0;
      carry = total >> 32;
    }
    if (carry != 0) return carry < 0 ? -1 : 1;
    return nonzero ? 1 : 0;
  }

 private:
  // Three floats: 2^-149 with 24-bit mantissas' slack is 2^-172 each; a double 2^-1126.
  static constexpr int lowest_exponent = 1664;
  // Up to three floats of 2^128 and a double of 2^1024, and 24 such terms.
  static constexpr std::size_t limb_count = (lowest_exponent + 3 * 128 + 1024 + 8) / 32 + 2;
  std::array<std::int64_t, limb_count> limbs_{};
};

int exact_plane_side(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::dvec4 point) {
  ExactSum sum;
  const auto add = [&](int sign, float p, float q, float r, double s) {
    if (p == 0 || q == 0 || r == 0 || s == 0) return;
    const Parts m = split(p), n = split(q), o = split(r), t = split(s);
    sum.add(static_cast<__int128>(sign * m.mantissa * n.mantissa) * o.mantissa * t.mantissa,
            m.exponent + n.exponent + o.exponent + t.exponent);
  };
  // (a×b + b×c + c×a)·point.xyz - (a×b)·c point.w, product by product.
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (const auto& [p, q] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      add(+1, p[j], q[k], 1.0f, point[i]);
      add(-1, p[k], q[j], 1.0f, point[i]);
    }
    add(-1, a[j], b[k], c[i], point.w);
    add(+1, a[k], b[j], c[i], point.w);
  }
  return sum.sign();
}

}  // namespace

int plane_side(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::dvec4 point) {
  const glm::dvec3 origin(a), u = glm::dvec3(b) - origin, v = glm::dvec3(c) - origin;
  double value = 0, magnitude = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double forth = u[j] * v[k], back = u[k] * v[j], moved = point.w * origin[i];
    value += (forth - back) * (point[i] - moved);
    magnitude += (std::abs(forth) + std::abs(back)) * (std::abs(point[i]) + std::abs(moved));
  }
  // Each term carries two roundings of differences, one of a product, one of a difference, two of
  // point - w a, one of the last product and three of the sum: 10 units to first order.
  const double bound = 16 * unit_roundoff * magnitude;
  if (bound > smallest_trusted && std::isfinite(magnitude)) {
    if (value > bound) return +1;
    if (value < -bound) return -1;
  }
  return exact_plane_side(a, b, c, point);
}

bool collinear(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::dvec3 p(a), q(b), r(c), u = q - p, v = r - p;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double forth = u[j] * v[k], back = u[k] * v[j];
    const double bound = 16 * unit_roundoff * (std::abs(forth) + std::abs(back));
    if (std::abs(forth - back) > bound && bound > smallest_trusted) return false;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    ExactSum sum;
    const auto add = [&sum](int sign, float x, float y) {
      const Parts m = split(x), n = split(y);
      sum.add(static_cast<__int128>(sign * m.mantissa) * n.mantissa, m.exponent + n.exponent);
    };
    for (const auto& [x, y] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      add(+1, x[j], y[k]);
      add(-1, x[k], y[j]);
    }
    if (sum.sign() != 0) return false;
  }
  return true;
}

}  // namespace shadowlab::scene
