#include "shadow/plan.h"

#include <algorithm>
#include <cmath>

#include "shadow/facing.h"
#include "shadow/reach.h"
#include "shadow/view_frustum.h"

namespace shadowlab::shadow {
namespace {

// The view's axes and scales, in which depths, pixels and their tolerances are told.
struct Eye {
  Eye(const scene::Camera& camera, glm::ivec2 picture)
      : position(camera.eye),
        view(camera.view()),
        size(picture),
        slope(std::tan(glm::radians(camera.fovy) / 2)),
        aspect(double(picture.x) / double(picture.y)),
        near(camera.near) {}

  double depth(glm::dvec3 point) const { return -(view * glm::dvec4(point, 1)).z; }

  // How far GL may move a surface at this depth against the volumes: 1/32 of a pixel (corners are
  // at 1/256, and the offset of a slope is 1/512) and eight steps of 24-bit depth (the offset is
  // two, and each depth is rounded).
  double tolerance(double z) const {
    z = std::max(z, near);
    return z * slope * 2 / size.y / 32 + 8 * z * z / (near * 0x1p24);
  }

  glm::dvec2 pixel(glm::dvec3 point) const {
    const glm::dvec4 p = view * glm::dvec4(point, 1);
    const double scale = 1 / (std::max(-p.z, near) * slope);
    return {(p.x * scale / aspect + 1) / 2 * size.x, (p.y * scale + 1) / 2 * size.y};
  }

  glm::dvec3 position;
  glm::dmat4 view;
  glm::dvec2 size;
  double slope, aspect, near;
};

// An object's box, and what of its surface the camera sees.
struct Body {
  scene::Bounds bounds;  // model space
  Crate crate;
  double farthest = 0;  // depth
  std::vector<Polygon> seen;
  bool shadowed = false;
};

// Every object's box, grown.
std::vector<Body> bodies_of(const scene::Scene& scene, const Eye& eye) {
  std::vector<Body> bodies(scene.objects.size());
  double reach = 0;  // no coordinate relative to the eye is larger
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    bodies[i].bounds = scene::bounds(*object.mesh);
    if (bodies[i].bounds.empty()) continue;
    bodies[i].crate = crate_around(bodies[i].bounds, object.model, 0);
    for (std::size_t c = 0; c < 8; ++c) {
      const glm::dvec3 corner = bodies[i].crate.corner(c);
      reach = std::max(reach, glm::length(corner - eye.position));
      bodies[i].farthest = std::max(bodies[i].farthest, eye.depth(corner));
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].bounds.empty()) continue;
    const double room = 1e-6 * reach + eye.tolerance(bodies[i].farthest);
    bodies[i].crate = crate_around(bodies[i].bounds, scene.objects[i].model, room);
    bodies[i].farthest += 2 * room;
  }
  return bodies;
}

// The view, a pixel wider on each side, to beyond the farthest body; nothing where all are behind.
std::optional<Hexahedron> view_of(const scene::Camera& camera, const Eye& eye,
                                  const std::vector<Body>& bodies) {
  double farthest = 0;
  for (const Body& body : bodies) farthest = std::max(farthest, body.farthest);
  if (farthest <= eye.near) return {};
  const glm::dvec2 wider = 1.0 + 2.0 / eye.size;
  scene::Camera wide = camera;
  wide.fovy = glm::degrees(2 * std::atan(eye.slope * wider.y));
  return frustum(wide, eye.aspect * wider.x / wider.y, eye.near * (1 - 1e-6), 2 * farthest);
}

// The surface of what `crate` and the view have in common.
std::vector<Polygon> seen_of(const Crate& crate, const Hexahedron& view) {
  bool within = true;
  for (const glm::dvec4& plane : view.planes) {
    const glm::dvec3 normal(plane);
    const double middle = glm::dot(normal, crate.center) + plane.w;
    double around = 0;
    for (const glm::dvec3& half : crate.half) around += std::abs(glm::dot(normal, half));
    if (middle + around < 0) return {};
    within = within && middle - around >= 0;
  }
  const Hexahedron shape = hexahedron(crate);
  if (!within) return common_sides(shape, view);
  const auto sides = sides_of(shape);
  return {sides.begin(), sides.end()};
}

struct Extent {
  glm::dvec2 low{+1e300}, high{-1e300};
  bool empty() const { return low.x > high.x; }
  void add(glm::dvec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Extent& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  // The pixels, one more around, as far as they are in the picture.
  PixelRectangle pixels(glm::dvec2 size) const {
    if (empty()) return {};
    const glm::ivec2 first(glm::clamp(glm::floor(low) - 1.0, glm::dvec2(0), size)),
        last(glm::clamp(glm::ceil(high) + 1.0, glm::dvec2(0), size));
    return {first.x, first.y, last.x - first.x, last.y - first.y};
  }
};

// Where the camera sees boxes that the shadow meets. A body that the reach goes into has a part of
// its surface inside: the reach is convex and has no end, the body has one.
Extent met_by(const Reach& reach, std::vector<Body>& bodies, const Eye& eye) {
  Extent met;
  for (Body& body : bodies) {
    if (body.seen.empty() || reach.parts_from(body.crate)) continue;
    Extent here;
    for (const Polygon& side : body.seen) {
      for (const glm::dvec3& corner : reach.inside(side)) here.add(eye.pixel(corner));
    }
    if (here.empty()) continue;
    body.shadowed = true;
    met.add(here);
  }
  return met;
}

Plan::Why why_dropped(const Reach& reach, const std::optional<Hexahedron>& view) {
  if (!view) return Plan::Why::outside_view;
  for (const Polygon& side : sides_of(*view)) {
    if (!reach.inside(side).empty()) return Plan::Why::meets_nothing;
  }
  return Plan::Why::outside_view;
}

}  // namespace

Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
          glm::ivec2 picture) {
  const Eye eye(camera, picture);
  light = normalized_light(light);
  std::vector<Body> bodies = bodies_of(scene, eye);
  const auto view = view_of(camera, eye, bodies);
  for (Body& body : bodies) {
    if (view && !body.bounds.empty()) body.seen = seen_of(body.crate, *view);
  }
  Plan plan;
  Extent all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (!object.casts() || bodies[i].bounds.empty()) continue;
    const Reach reach(bodies[i].crate, light);
    const Extent met = met_by(reach, bodies, eye);
    if (met.empty()) {
      plan.dropped.push_back({i, why_dropped(reach, view)});
      continue;
    }
    all.add(met);
    plan.casters.push_back(
        {i, apart_from_near_pyramid(camera, eye.aspect, light, bodies[i].bounds, object.model),
         met.pixels(eye.size)});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].seen.empty()) plan.seen.push_back(i);
    if (bodies[i].shadowed) plan.shadowed.push_back(i);
  }
  plan.shadows = all.pixels(eye.size);
  return plan;
}

}  // namespace shadowlab::shadow
