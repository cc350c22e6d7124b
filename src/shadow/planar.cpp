#include "shadow/planar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace shadowlab::shadow {

namespace {

/// A sum of four rounded products of numbers that were themselves rounded is wrong by less than
/// 8 half units in the last place of the sum of their sizes. Four times that, for planes and lights
/// that come out of a few operations: below it nobody knows the sum's sign.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// 1/1024: exact, and no caster is as near to its light.
constexpr double nearest = 0x1p-10;

bool finite(const glm::dvec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

double largest(const glm::dvec4& v) {
  const glm::dvec4 size = glm::abs(v);
  return std::max(std::max(size.x, size.y), std::max(size.z, size.w));
}

/// Scaled exactly, to a largest component in [1, 2): products cannot overflow.
glm::dvec4 order_one(const glm::dvec4& v) {
  const int exponent = std::ilogb(largest(v));
  return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent),
          std::scalbn(v.w, -exponent)};
}

double sum_of_sizes(const glm::dvec4& a, const glm::dvec4& b) {
  return glm::dot(glm::abs(a), glm::abs(b));
}

/// A light with w ≥ 0 and the plane whose positive side it is on, each of order one.
struct Oriented {
  glm::dvec4 plane;
  glm::dvec4 light;
};

Oriented oriented(glm::dvec4 plane, glm::dvec4 light) {
  if (!finite(plane)) throw InputError("The shadow plane's four numbers must be finite.");
  if (!finite(light)) throw InputError("The light's four numbers must be finite.");
  if (plane != glm::dvec4(0.0)) plane = order_one(plane);
  // A normal that vanishes beside d is as good as zero.
  if (!(glm::dot(glm::dvec3(plane), glm::dvec3(plane)) > 0.0)) {
    throw InputError(
        "The shadow plane's normal is zero; give a plane (a, b, c, d) with one of a, b, c not 0.");
  }
  if (light == glm::dvec4(0.0)) {
    throw InputError(
        "The light is (0, 0, 0, 0); give a point with w = 1 or a direction with w = 0.");
  }
  light = order_one(light);
  if (light.w < 0.0) light = -light;
  const double product = glm::dot(plane, light);
  if (!(std::abs(product) > rounding * sum_of_sizes(plane, light))) {
    throw InputError(light.w > 0.0 ? "The light is in the shadow plane, so it throws no shadow on "
                                     "it; move the light or the plane."
                                   : "The light's direction is along the shadow plane, so it "
                                     "throws no shadow on it; turn one of them.");
  }
  return {product > 0.0 ? plane : -plane, light};
}

/// (P·L) I − L Pᵀ, scaled to 1 ≤ P·L < 2. Takes P·L > 0.
glm::dmat4 projection(const glm::dvec4& plane, const glm::dvec4& light) {
  const double product = glm::dot(plane, light);
  const double scale = std::scalbn(1.0, -std::ilogb(product));
  // glm's columns: outerProduct(L, P)[j][i] = L[i] P[j].
  return (glm::dmat4(product) - glm::outerProduct(light, plane)) * scale;
}

}  // namespace

glm::dmat4 planar(glm::dvec4 plane, glm::dvec4 light) {
  const Oriented o = oriented(plane, light);
  return projection(o.plane, o.light);
}

glm::dmat4 planar_from_origin(glm::dvec4 plane) { return planar(plane, {0, 0, 0, 1}); }

glm::dmat4 planar_from_point(glm::dvec4 plane, glm::dvec3 point) {
  return planar(plane, glm::dvec4(point, 1.0));
}

glm::dmat4 planar_along(glm::dvec4 plane, glm::dvec3 direction) {
  return planar(plane, glm::dvec4(direction, 0.0));
}

PlanarProjection planar_near(glm::dvec4 plane, glm::dvec4 light, glm::dvec3 near) {
  if (!finite(glm::dvec4(near, 1.0))) {
    throw InputError("The point that a planar shadow is computed near must be finite.");
  }
  const Oriented o = oriented(plane, light);
  const glm::dvec3 normal(o.plane);
  const glm::dvec3 origin =
      near - normal * (glm::dot(o.plane, glm::dvec4(near, 1.0)) / glm::dot(normal, normal));
  // Relative to a point of the plane its d is zero. P·L stays positive: it was beyond rounding.
  const glm::dvec4 local_light(glm::dvec3(o.light) - o.light.w * origin, o.light.w);
  if (!(glm::dot(normal, glm::dvec3(local_light)) > 0.0)) {
    throw InputError(
        "The light is in the shadow plane within rounding; move the light or the plane.");
  }
  return {origin, projection(glm::dvec4(normal, 0.0), local_light)};
}

glm::dmat4 model_view(const PlanarProjection& projection, const glm::dmat4& view,
                      const glm::dmat4& model) {
  glm::dmat4 from_plane = view;
  from_plane[3] = view * glm::dvec4(projection.origin, 1.0);
  glm::dmat4 to_plane = model;
  to_plane[3] -= glm::dvec4(projection.origin, 0.0);
  return from_plane * projection.local * to_plane;
}

glm::dvec4 plane_toward(glm::dvec4 plane, glm::dvec4 light) {
  const Oriented o = oriented(plane, light);
  return o.plane / glm::length(glm::dvec3(o.plane));
}

PlanarReach planar_reach(glm::dvec4 plane, glm::dvec4 light, const scene::Bounds& caster) {
  const Oriented o = oriented(plane, light);
  if (caster.empty()) return PlanarReach::none;
  const glm::dvec3 normal(o.plane);
  const glm::dvec3 farthest = glm::max(glm::abs(caster.low), glm::abs(caster.high));
  const double slack = rounding * sum_of_sizes(o.plane, glm::dvec4(farthest, 1.0));

  // The least and the greatest P·v over the box, at the corners along and against the normal.
  const glm::dvec3 along =
      glm::mix(caster.low, caster.high, glm::greaterThan(normal, glm::dvec3(0.0)));
  const glm::dvec3 against =
      glm::mix(caster.high, caster.low, glm::greaterThan(normal, glm::dvec3(0.0)));
  const double top = glm::dot(o.plane, glm::dvec4(along, 1.0));
  const double bottom = glm::dot(o.plane, glm::dvec4(against, 1.0));
  const double light_height = glm::dot(o.plane, o.light);  // times w, which spares a division

  if (top <= slack || o.light.w * bottom >= light_height) return PlanarReach::none;
  const bool whole = bottom >= -slack && o.light.w * top < light_height;
  return whole ? PlanarReach::whole : PlanarReach::part;
}

glm::dmat4 parallelogram(glm::dvec3 corner, glm::dvec3 ex, glm::dvec3 ey, glm::dvec4 light) {
  if (!finite(light) || !finite(glm::dvec4(corner, 1.0)) ||
      !finite(glm::dvec4(ex, glm::length(ey)))) {
    throw InputError("The receiver's corner and sides and the light must be finite.");
  }
  const glm::dvec3 normal = glm::cross(ex, ey);
  // Relative to the area of the rectangle with these sides: the sine of their angle.
  if (!(glm::length(normal) > 1e-12 * glm::length(ex) * glm::length(ey))) {
    throw InputError(
        "The receiver's two sides are zero or parallel; they must span a parallelogram.");
  }
  const bool at_infinity = light.w == 0.0;
  const glm::dvec3 apex = at_infinity ? corner : glm::dvec3(light) / light.w;
  // The third axis: from a point light to the corner, or back toward a light at infinity.
  const glm::dvec3 axis = at_infinity ? glm::dvec3(light) : corner - apex;
  const double volume = glm::dot(normal, axis);
  const double size =
      glm::length(axis) + (at_infinity ? 0.0 : glm::length(corner) + glm::length(apex));
  if (!(std::abs(volume) > rounding * glm::length(normal) * size)) {
    throw InputError("The light is in the receiver's plane; move one of them.");
  }
  // v − apex = s ex + t ey + u axis: each coordinate is a plane, of the basis dual to (ex, ey,
  // axis).
  const auto coordinate = [&](const glm::dvec3& dual) {
    return glm::dvec4(dual, -glm::dot(dual, apex)) / volume;
  };
  const glm::dvec4 s = coordinate(glm::cross(ey, axis));
  const glm::dvec4 t = coordinate(glm::cross(axis, ex));
  const glm::dvec4 u = coordinate(normal);
  const glm::dvec4 one(0, 0, 0, 1);

  // A point light: the ray hits the receiver at (s, t)/u, where u = 1.
  const double range = std::max(glm::length(ex), glm::length(ey)) / nearest;
  const glm::dvec4 z =
      at_infinity ? one - u * (glm::length(axis) / range) : (u - nearest * one) / (1.0 - nearest);
  return glm::transpose(glm::dmat4(s, t, z, at_infinity ? one : u));
}

}  // namespace shadowlab::shadow
