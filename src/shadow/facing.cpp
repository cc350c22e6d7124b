#include "shadow/facing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_inverse.hpp>

#include "core/error.h"
#include "scene/exact_sign.h"

// One body compiled for several instruction sets; which one runs cannot be seen in the results,
// since every sign that is near its bound is decided exactly.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SHADOWLAB_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define SHADOWLAB_CLONES
#endif

namespace shadowlab::shadow {
namespace {

// Triangles decided together: a block with a doubtful one is looked at again.
constexpr std::size_t block = 512;

struct PlaneComponents {
  const float *x, *y, *z, *d;
};

// The topmost bit of a float is its sign, and without it floats are ordered as their bits are: so
// each question is one operation of integers.
constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();

/// Whether all n triangles are clear of the bound; out = 1 where lit, else 0.
SHADOWLAB_CLONES
bool decide_lit(PlaneComponents p, float lx, float ly, float lz, float lw, float bound,
                std::size_t n, std::int8_t* __restrict out) {
  std::int32_t least = largest;
  for (std::size_t i = 0; i < n; ++i) {
    const float value = (p.x[i] * lx + p.y[i] * ly) + (p.z[i] * lz + p.d[i] * lw);
    const auto bits = std::bit_cast<std::int32_t>(value);
    const std::int32_t magnitude = bits & largest;
    least = magnitude < least ? magnitude : least;
    out[i] = static_cast<std::int8_t>(1 + (bits >> 31));
  }
  return least > std::bit_cast<std::int32_t>(bound);
}

/// The same; out = 1 where lit, else -1.
SHADOWLAB_CLONES
bool decide_sign(PlaneComponents p, float lx, float ly, float lz, float lw, float bound,
                 std::size_t n, std::int8_t* __restrict out) {
  std::int32_t least = largest;
  for (std::size_t i = 0; i < n; ++i) {
    const float value = (p.x[i] * lx + p.y[i] * ly) + (p.z[i] * lz + p.d[i] * lw);
    const auto bits = std::bit_cast<std::int32_t>(value);
    const std::int32_t magnitude = bits & largest;
    least = magnitude < least ? magnitude : least;
    out[i] = static_cast<std::int8_t>(1 + 2 * (bits >> 31));
  }
  return least > std::bit_cast<std::int32_t>(bound);
}

struct LitSign {
  static constexpr bool only_lit = true;
  std::int8_t operator()(int sign) const { return sign > 0 ? 1 : 0; }
};
struct AnySign {
  static constexpr bool only_lit = false;
  std::int8_t operator()(int sign) const { return static_cast<std::int8_t>(sign); }
};

}  // namespace

glm::dvec4 normalized_light(glm::dvec4 light) {
  const double largest = std::max({std::abs(light.x), std::abs(light.y), std::abs(light.z)});
  if (!std::isfinite(largest + std::abs(light.w))) {
    throw InputError("The light's coordinates are not finite numbers; give it a place.");
  }
  if (largest == 0 && light.w == 0) {
    throw InputError("The light is (0, 0, 0, 0), which is no place and no direction; set w to 1.");
  }
  return light.w < 0 ? -light : light;
}

glm::dvec4 light_in_model_space(const glm::dmat4& model, glm::dvec4 light) {
  const double determinant = glm::determinant(model);
  if (!std::isfinite(determinant) || determinant == 0) {
    throw InputError("The object's model matrix has no inverse; its scale must not be 0.");
  }
  return normalized_light(glm::inverse(model) * light);
}

FacingPlanes::FacingPlanes(std::vector<glm::vec3> positions, std::vector<scene::Triangle> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)) {
  const std::size_t count = triangles_.size();
  for (auto* column : {&x_, &y_, &z_, &d_}) column->resize(count);
  if (count == 0) return;
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const scene::Triangle& triangle : triangles_) {
    for (const std::uint32_t vertex : triangle) {
      low = glm::min(low, glm::dvec3(positions_[vertex]));
      high = glm::max(high, glm::dvec3(positions_[vertex]));
    }
  }
  center_ = (low + high) * 0.5;
  radius_ = glm::length(high - low) * 0.5 * (1 + 1e-12);
  for (int i = 0; i < 3; ++i) coordinate_ = std::max({coordinate_, -low[i], high[i]});
  for (std::size_t t = 0; t < count; ++t) {
    const glm::dvec3 a(positions_[triangles_[t][0]]);
    const glm::dvec3 u = glm::dvec3(positions_[triangles_[t][1]]) - a;
    const glm::dvec3 v = glm::dvec3(positions_[triangles_[t][2]]) - a;
    const glm::dvec3 n = glm::cross(u, v);
    const double length = glm::length(n);
    // A sliver's normal is lost to cancellation: zero makes it doubtful for every light.
    if (!(length > 0x1p-20 * glm::length(u) * glm::length(v))) continue;
    x_[t] = static_cast<float>(n.x / length);
    y_[t] = static_cast<float>(n.y / length);
    z_[t] = static_cast<float>(n.z / length);
    d_[t] = static_cast<float>(glm::dot(n / length, center_ - a) / radius_);
  }
}

// The value is (n·l + d w') in units where |l| + w' = 1, with l = (L.xyz - L.w center) / scale and
// w' = L.w radius / scale. With e = 2^-24 (half an ulp of a float), to first order: the roundings
// of n, d, l and w' give 2e, evaluation (a product and two sums for each term) 3e, the normal
// itself (see the sliver test) 2^-29. 16 e holds all that with room. In double, the subtractions of
// center err by 2^-53 of coordinates that need not be small beside radius and scale.
FacingPlanes::ScaledLight FacingPlanes::scaled(glm::dvec4 light) const {
  // A power of two first, exactly, so that no square overflows.
  const double largest =
      std::max({std::abs(light.x), std::abs(light.y), std::abs(light.z), light.w});
  light = light * std::ldexp(1.0, -std::ilogb(largest));
  const glm::dvec3 from_center = glm::dvec3(light) - light.w * center_;
  const double scale = glm::length(from_center) + light.w * radius_;
  const double subtracted = (glm::length(glm::dvec3(light)) + 2 * light.w * coordinate_) / scale +
                            2 * coordinate_ / radius_;
  const double bound = 16 * 0x1p-24 + 16 * 0x1p-53 * subtracted;
  const glm::dvec3 l = from_center / scale;
  return {glm::vec4(l, light.w * radius_ / scale), static_cast<float>(bound * (1 + 1e-6))};
}

template <class Sign>
void FacingPlanes::decide(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out,
                          Sign sign) const {
  const auto [l, bound] = scaled(light);
  constexpr bool only_lit = Sign::only_lit;
  for (std::size_t begin = 0; begin < out.size(); begin += block) {
    const std::size_t n = std::min(block, out.size() - begin), t = first + begin;
    const PlaneComponents planes{&x_[t], &y_[t], &z_[t], &d_[t]};
    std::int8_t* const decided = out.data() + begin;
    const auto kernel = only_lit ? decide_lit : decide_sign;
    if (kernel(planes, l.x, l.y, l.z, l.w, bound, n, decided)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const float value =
          (planes.x[i] * l.x + planes.y[i] * l.y) + (planes.z[i] * l.z + planes.d[i] * l.w);
      if (std::abs(value) > bound) continue;
      const auto& [a, b, c] = triangles_[t + i];
      decided[i] = sign(scene::plane_side(positions_[a], positions_[b], positions_[c], light));
    }
  }
}

void FacingPlanes::lit(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out) const {
  decide(light, first, out, LitSign{});
}

void FacingPlanes::signs(glm::dvec4 light, std::size_t first, std::span<std::int8_t> out) const {
  decide(light, first, out, AnySign{});
}

// In radii: nearer than this a light is on a triangle, and is moved to twice that.
constexpr double on_triangle = 0x1p-18;

std::optional<glm::dvec3> FacingPlanes::beside(std::size_t t, glm::dvec3 p) const {
  const glm::dvec3 corners[3] = {positions_[triangles_[t][0]], positions_[triangles_[t][1]],
                                 positions_[triangles_[t][2]]};
  const glm::dvec3 n = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const double height = glm::dot(n, p - corners[0]), least = on_triangle * radius_;
  if (!(std::abs(height) < least)) return {};
  // Exactly in its plane the light sees it edge on: it throws nothing, and nothing is lost.
  const auto& [a, b, c] = triangles_[t];
  if (scene::plane_side(positions_[a], positions_[b], positions_[c], glm::dvec4(p, 1)) == 0)
    return {};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
    if (glm::dot(glm::cross(n, edge), p - corners[i]) < -least * glm::length(edge)) return {};
  }
  return p + n * ((height < 0 ? -2 : 2) * least - height);
}

glm::dvec4 FacingPlanes::beside(glm::dvec4 light) const {
  if (light.w == 0 || triangles_.empty()) return light;
  glm::dvec3 p = glm::dvec3(light) / light.w;
  if (!(glm::distance(p, center_) <= radius_ * (1 + on_triangle))) return light;
  // A corner has several triangles: off one the light may come onto the next.
  bool moved = false;
  for (int turn = 0; turn < 3; ++turn) {
    bool again = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const glm::dvec3 l = (p - center_) / radius_;
      const double height = x_[t] * l.x + y_[t] * l.y + z_[t] * l.z + d_[t];
      if (std::abs(height) > 2 * on_triangle) continue;
      if (const auto there = beside(t, p)) {
        p = *there;
        again = moved = true;
      }
    }
    if (!again) break;
  }
  return moved ? glm::dvec4(p, 1) : light;
}

}  // namespace shadowlab::shadow
