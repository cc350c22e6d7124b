#include "measure/places.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::measure {
namespace {

glm::dvec3 across(glm::dvec3 direction) {
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(direction, axis));
}

// A picture of one pixel, whose only ray goes from `from` to `to`.
scene::Camera ray_camera(glm::dvec3 from, glm::dvec3 to, double near, double far) {
  scene::Camera camera;
  camera.eye = from;
  camera.target = to;
  camera.up = across(to - from);
  camera.fovy = 1;
  camera.near = near;
  camera.far = far;
  return camera;
}

// The step of a 24-bit depth buffer at distance z, near plane n: the derivative of window depth
// n (1/n - 1/z) is n/z².
double depth_step(double z, double near) { return z * z / (near * 0x1p24); }

scene::Scene casters_of(const scene::Scene& scene) {
  scene::Scene casters;
  for (const scene::Object& object : scene.objects) {
    if (object.casts()) casters.objects.push_back(object);
  }
  return casters;
}

class Places {
 public:
  Places(const LitScene& lit_scene, const truth::Surface& surface, bool lit)
      : scene_(lit_scene.scene),
        tracer_(lit_scene.tracer),
        casters_(lit_scene.casters),
        edges_(lit_scene.edges),
        limit_(lit_scene.limit),
        radius_(lit_scene.radius),
        light_rounding_(lit_scene.light_rounding),
        light_(lit_scene.light()),
        rows_(lit_scene.rows),
        at_(surface),
        lit_(lit) {
    const glm::dvec3 position(light_);
    away_ = light_.w == 0 ? 1.0 : glm::distance(position, at_.point);
    toward_ = light_.w == 0 ? glm::normalize(position) : (position - at_.point) / away_;
  }

  bool any() const {
    return hidden_behind() || beside_a_sliver() || from_beside_the_light() || along_the_sight() ||
           before_a_side_edge_on() || across_the_light() || on_the_receiver() || under_the_offset();
  }

  // Of a caster in the very same place the tracer says the receiver, so that casters alone are
  // asked.
  bool any_caster() const {
    const glm::dvec3 eye = scene_.camera.eye;
    const double distance = glm::distance(eye, at_.point);
    const auto sight = ray_camera(eye, at_.point, distance * (1 - 1e-12) - rounding(),
                                  distance * (1 + 1e-12) + rounding() + depth_error());
    return casters_.surfaces(sight, 1, 1).surfaces[0].hit();
  }

 private:
  bool is_drawn(glm::dvec3 place) const { return tracer_.blocked(place, light_) != lit_; }

  // So many steps of the depth buffer at the surface, metres along the sight.
  double steps(double units) const {
    const scene::Camera& camera = scene_.camera;
    return units * depth_step(at_.depth, camera.near) * glm::distance(camera.eye, at_.point) /
           at_.depth;
  }

  // How far behind the surface another may be that is drawn for it: each pixel's depth is rounded,
  // and interpolated with as much error again; and what is counted against is moved on purpose.
  double depth_error() const { return steps(4 + limit_.eye_units); }

  bool hidden_behind() const {
    const scene::Camera& camera = scene_.camera;
    const double distance = glm::distance(camera.eye, at_.point), reach = depth_error();
    double near = distance * (1 + 1e-12) + rounding();
    for (int i = 0; i < 4 && near > 0 && near < distance + reach; ++i) {
      const auto ray = ray_camera(camera.eye, at_.point, near, distance + reach);
      const truth::Surface next = tracer_.surfaces(ray, 1, 1).surfaces[0];
      if (!next.hit()) return false;
      if ((tracer_.visibility(ray, scene_.lights[0], 1, 1, {}, 1).values[0] > 0.5f) == lit_)
        return true;
      near = next.depth * (1 + 1e-12) + rounding();
    }
    return false;
  }

  // Of the surface's place, metres: far from the world's origin its coordinates are long.
  double rounding() const {
    const glm::dvec3 size = glm::max(glm::abs(at_.point), glm::abs(scene_.camera.eye));
    return 0x1p-50 * std::max({size.x, size.y, size.z});
  }

  bool from_beside_the_light() const {
    if (light_rounding_ == 0) return false;
    const scene::Camera& camera = scene_.camera;
    const double distance = glm::distance(camera.eye, at_.point);
    const auto ray =
        ray_camera(camera.eye, at_.point, distance * (1 - 1e-12) - rounding(), 2 * distance);
    if (!tracer_.surfaces(ray, 1, 1).surfaces[0].hit()) return false;  // else it would be lit
    for (int i = 0; i < 24; ++i) {
      scene::Light light = scene_.lights[0];
      const double step = std::ldexp(light_rounding_, -(i / 6));
      light.position[i % 3] += i % 6 < 3 ? step : -step;
      if ((tracer_.visibility(ray, light, 1, 1, {}, 1).values[0] > 0.5f) == lit_) return true;
    }
    return false;
  }

  // Where from `a` to `b`, as parts of the way, an edge of a caster is before the light: there
  // alone light and dark change.
  struct Change {
    double part;
    std::size_t sides;
  };
  std::vector<Change> changes(glm::dvec3 a, glm::dvec3 b) const {
    const glm::dvec3 along = b - a;
    const glm::dvec3 normal = glm::cross(along, glm::dvec3(light_) - light_.w * a);
    std::vector<Change> found;
    for (const Edge& edge : edges_) {
      const double from = glm::dot(normal, edge.a - a), to = glm::dot(normal, edge.b - a);
      if (from == to || (from > 0) == (to > 0)) continue;
      const glm::dvec3 meets = glm::mix(edge.a, edge.b, from / (from - to));
      const glm::dvec3 beside = glm::cross(normal, light_.w * meets - glm::dvec3(light_));
      const double part = glm::dot(beside, meets - a) / glm::dot(beside, along);
      if (part > 0 && part < 1) found.push_back({part, edge.sides});
    }
    std::ranges::sort(found, {}, &Change::part);
    return found;
  }

  // Whether somewhere from `a` to `b` is as drawn: between each two changes a place is asked about.
  // Where two sides of volumes are so near, either may be counted and the other not.
  bool is_drawn_between(glm::dvec3 a, glm::dvec3 b) const {
    const auto found = changes(a, b);
    double last = 0;
    std::size_t sides = 0;
    for (const Change& change : found) {
      sides += change.sides;
      if (sides > 1 || is_drawn(glm::mix(a, b, (last + change.part) / 2))) return true;
      last = change.part;
    }
    return is_drawn(glm::mix(a, b, (last + 1) / 2));
  }

  // Late, and early where that cannot be a caster's shadow on itself.
  bool along_the_sight() const {
    if (limit_.eye_units == 0) return false;
    const scene::Camera& camera = scene_.camera;
    const double distance = glm::distance(camera.eye, at_.point);
    const glm::dvec3 back = (camera.eye - at_.point) / distance;
    const double reach = std::min(steps(limit_.eye_units), distance);
    return is_drawn_between(at_.point, at_.point + back * reach) ||
           (!scene_.objects[at_.object].casts() &&
            is_drawn_between(at_.point, at_.point - back * reach));
  }

  // Of the edges of casters, whether one passes the segment within `share` of the distance from the
  // segment's end, or within `least` metres.
  bool passes(const Edge& segment, double share, double least) const {
    const double length = glm::distance(segment.a, segment.b);
    return std::ranges::any_of(edges_, [&](const Edge& edge) {
      const glm::dvec2 at = nearest(segment, edge);
      const double apart =
          glm::distance(glm::mix(segment.a, segment.b, at.x), glm::mix(edge.a, edge.b, at.y));
      return apart <= std::max(least, share * (1 - at.x) * length);
    });
  }

  // 1/128 of a pixel at distance 1. A rasterizer moves corners by 1/256: what is narrower than that
  // (and than the lattice on which edges are looked for) may come and go.
  double snapped() const {
    return 2 * std::tan(glm::radians(scene_.camera.fovy) / 2) / rows_ / 128;
  }

  bool beside_a_sliver() const {
    const scene::Camera& camera = scene_.camera;
    const double snapped = this->snapped();
    const glm::dvec3 sight = at_.point - camera.eye;
    const double stretch =
        1 / std::max(1e-3, std::abs(glm::dot(glm::normalize(sight), at_.normal)));
    return passes({at_.point, camera.eye}, snapped, 0) ||
           passes(ray(), 0, snapped * at_.depth * stretch);
  }

  // A side of a volume that the eye sees edge on: both its edges, from an edge of a caster away
  // from the light, pass the sight within what corners are moved by. Its depth there is any of
  // those that it has along the sight, so that it may be counted on the wrong side of the surface.
  bool before_a_side_edge_on() const {
    if (limit_.eye_units == 0) return false;
    const double far = 4 * (radius_ + glm::distance(scene_.camera.eye, at_.point)),
                 share = snapped();
    const Edge sight{
        scene_.camera.eye,
        glm::mix(scene_.camera.eye, at_.point, far / glm::distance(scene_.camera.eye, at_.point))};
    const auto passed_by = [&](glm::dvec3 corner) {
      const glm::dvec3 away = light_.w * corner - glm::dvec3(light_);
      const Edge edge{corner, corner + away * (far / glm::length(away))};
      const glm::dvec2 at = nearest(sight, edge);
      return glm::distance(glm::mix(sight.a, sight.b, at.x), glm::mix(edge.a, edge.b, at.y)) <=
             share * at.x * far;
    };
    return std::ranges::any_of(
        edges_, [&](const Edge& edge) { return passed_by(edge.a) && passed_by(edge.b); });
  }

  Edge ray() const {
    return {at_.point, light_.w == 0 ? at_.point + toward_ * (4 * radius_) : glm::dvec3(light_)};
  }

  bool across_the_light() const { return limit_.across > 0 && is_beside_an_edge(limit_.across); }

  // Whether an edge of a caster is before the light, by so much across its rays.
  bool is_beside_an_edge(double across) const {
    return light_.w == 0 ? passes(ray(), 0, across) : passes(ray(), across, 0);
  }

  // Of the surface around, whose texture is filtered: beside an edge, or the foot of what stands
  // in it.
  bool on_the_receiver() const {
    if (limit_.on_receiver == 0) return false;
    if (is_beside_an_edge(limit_.on_receiver / away_)) return true;
    const glm::dvec3 u = across(at_.normal), v = glm::cross(at_.normal, u);
    constexpr int directions = 16;
    for (int i = 0; i < directions; ++i) {
      const double angle = glm::radians(360.0 / directions * i);
      if (is_drawn(at_.point + limit_.on_receiver * (u * std::cos(angle) + v * std::sin(angle))))
        return true;
    }
    return false;
  }

  // The caster nearest to the light before the surface.
  truth::Surface first_before() const {
    if (light_.w != 0) {
      return casters_.surfaces(ray_camera(glm::dvec3(light_), at_.point, 1e-9 * away_, away_), 1, 1)
          .surfaces[0];
    }
    const double far = 4 * radius_;
    return casters_
        .surfaces(ray_camera(at_.point + toward_ * far, at_.point, 1e-9 * far, far), 1, 1)
        .surfaces[0];
  }

  // Of a plane over the light's rays.
  double slope(glm::dvec3 normal) const {
    const double cosine = std::abs(glm::dot(normal, toward_));
    return std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, 1e-12);
  }

  // A place in the dark is lit where what hides it from the light was pushed past it.
  bool under_the_offset() const {
    if (std::isinf(limit_.light_units)) return true;     // a map that tells no depths at all
    if (!lit_ || limit_.light_units == 0) return false;  // no depths are compared
    const truth::Surface first = first_before();
    if (!first.hit()) return true;  // edge on, or the surface itself
    // The caster is pushed by its slope, and the place itself takes off what its plane climbs.
    const double offset =
        limit_.across * away_ * (2 * slope(first.normal) + slope(at_.normal)) +
        limit_.light_units *
            (light_.w == 0 ? 0x1p-24 * limit_.light_range : depth_step(away_, limit_.light_near)) +
        0x1p-20 * glm::distance(scene_.camera.eye, at_.point);  // by which a place is told
    return glm::dot(first.point - at_.point, toward_) <= offset;
  }

  const scene::Scene& scene_;
  const truth::Tracer& tracer_;
  const truth::Tracer& casters_;
  const std::vector<Edge>& edges_;
  const recipe::Limit& limit_;
  double radius_, light_rounding_;
  glm::dvec4 light_;
  int rows_;
  const truth::Surface& at_;
  bool lit_;
  glm::dvec3 toward_{0};
  double away_ = 1;  ///< metres to the light; 1 to one at infinity: what limit.across is a part of
};

}  // namespace

LitScene::LitScene(const scene::Scene& lit_scene, const truth::Tracer& scene_tracer,
                   const recipe::Limit& technique, int rows_of_pixels)
    : scene(lit_scene),
      tracer(scene_tracer),
      limit(technique),
      rows(rows_of_pixels),
      caster_scene(casters_of(scene)),
      casters(caster_scene),
      edges(caster_edges(caster_scene, light())) {
  scene::Bounds all;
  for (const scene::Object& object : scene.objects)
    all = merge(all, scene::bounds(*object.mesh, object.model));
  radius = all.radius();
  double least = 1e300;
  for (const scene::Object& object : caster_scene.objects) {
    const scene::Bounds own = scene::bounds(*object.mesh, object.model);
    least = std::min(least, own.radius() + glm::distance(own.center(), glm::dvec3(light())));
  }
  // FacingPlanes::beside moves it by 2^-17 and less.
  light_rounding = light().w == 0 ? 0 : 0x1p-17 * least;
}

bool is_as_near_as_a_caster(const LitScene& scene, const truth::Surface& surface) {
  return Places(scene, surface, false).any_caster();
}

bool some_place_is(const LitScene& scene, const truth::Surface& surface, bool lit) {
  return Places(scene, surface, lit).any();
}

}  // namespace shadowlab::measure
