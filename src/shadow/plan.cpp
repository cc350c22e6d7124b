#include "shadow/plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "shadow/facing.h"
#include "shadow/occlusion.h"
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
  double area() const { return size.x * size.y; }

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
  double farthest = 0;        // depth
  std::vector<Polygon> seen;  // of the surface of what it has in common with the view
  Extent extent;
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

// The pixels, one more around, as far as they are in the picture.
PixelRectangle pixels_of(const Extent& extent, glm::dvec2 size) {
  if (extent.empty()) return {};
  const glm::ivec2 first(glm::clamp(glm::floor(extent.low) - 1.0, glm::dvec2(0), size)),
      last(glm::clamp(glm::ceil(extent.high) + 1.0, glm::dvec2(0), size));
  return {first.x, first.y, last.x - first.x, last.y - first.y};
}

double area_of(const Extent& extent, glm::dvec2 size) {
  return static_cast<double>(pixels_of(extent, size).area());
}

// A body whose mesh is its box, before the near plane, hides what is behind it.
void hide_behind(const Body& body, const glm::dmat4& model, const Eye& eye, Occlusion& occlusion) {
  std::array<glm::dvec3, 8> corners;
  std::array<glm::dvec2, 8> pixels;
  for (std::size_t i = 0; i < 8; ++i) {
    const scene::Bounds& box = body.bounds;
    const glm::dvec3 corner((i & 1) ? box.high.x : box.low.x, (i & 2) ? box.high.y : box.low.y,
                            (i & 4) ? box.high.z : box.low.z);
    corners[i] = glm::dvec3(model * glm::dvec4(corner, 1));
    if (eye.depth(corners[i]) < eye.near * (1 + 1e-6)) return;
    pixels[i] = eye.pixel(corners[i]);
  }
  double farthest = 0;  // of the faces that are turned to the eye
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t k = std::size_t{1} << axis, u = std::size_t{1} << (axis + 1) % 3,
                      v = std::size_t{1} << (axis + 2) % 3;
    for (const std::size_t side : {std::size_t{0}, k}) {
      glm::dvec3 normal = glm::cross(corners[u] - corners[0], corners[v] - corners[0]);
      const glm::dvec3 outward = corners[side] - corners[side ^ k];
      if (glm::dot(normal, outward) < 0) normal = -normal;
      if (glm::dot(normal, eye.position - corners[side]) <= 0) continue;
      for (const std::size_t corner : {side, side | u, side | v, side | u | v})
        farthest = std::max(farthest, eye.depth(corners[corner]));
    }
  }
  if (farthest > 0) occlusion.add(pixels, farthest);
}

Occlusion occlusion_of(const scene::Scene& scene, const std::vector<Body>& bodies, const Eye& eye) {
  Occlusion occlusion{glm::ivec2(eye.size)};
  std::map<const scene::Mesh*, bool> filled;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].seen.empty()) continue;
    const scene::Mesh* mesh = scene.objects[i].mesh.get();
    const auto [known, is_new] = filled.try_emplace(mesh);
    if (is_new) known->second = fills_its_box(*mesh);
    if (known->second) hide_behind(bodies[i], scene.objects[i].model, eye, occlusion);
  }
  return occlusion;
}

// What of a body the camera sees inside the reach. A body that the reach goes into has a part of
// its surface inside: the reach is convex and has no end, the body has one. With the caster's
// corners in the body these are all the corners of what they have in common.
Extent common(const Reach& reach, const Crate& caster, const Body& body, const Eye& eye,
              Reach::Scratch& scratch) {
  Extent here;
  for (const Polygon& side : body.seen) {
    for (const glm::dvec3& corner : reach.inside(side, scratch))
      here.add(eye.pixel(corner), eye.depth(corner));
  }
  if (here.empty()) return here;
  const Hexahedron shape = hexahedron(body.crate);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 corner(caster.corner(i), 1);
    const double depth = eye.depth(corner);
    if (depth < eye.near) continue;
    const auto before = [&](const glm::dvec4& plane) { return glm::dot(plane, corner) >= 0; };
    if (std::ranges::all_of(shape.planes, before)) here.add(eye.pixel(corner), depth);
  }
  return here;
}

// Bodies that a caster is held against exactly; of more it is said to meet all that may be met.
constexpr int most_clipped = 4;

class Planner {
 public:
  Planner(const scene::Scene& scene, const scene::Camera& camera, glm::ivec2 picture)
      : eye_(camera, picture), bodies_(bodies_of(scene, eye_)), occlusion_(picture) {
    view_ = view_of(camera, eye_, bodies_);
    if (!view_) return;
    for (Body& body : bodies_) {
      if (body.bounds.empty()) continue;
      body.seen = seen_of(body.crate, *view_);
      for (const Polygon& side : body.seen) {
        for (const glm::dvec3& corner : side)
          body.extent.add(eye_.pixel(corner), eye_.depth(corner));
      }
    }
    occlusion_ = occlusion_of(scene, bodies_, eye_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& body = bodies_[i];
      if (!body.seen.empty() && occlusion_.hides(body.extent)) {
        body.seen.clear();
        body.extent = {};
      }
      if (!body.seen.empty()) largest_first_.push_back(i);
    }
    std::ranges::stable_sort(largest_first_, std::greater{},
                             [&](std::size_t i) { return area_of(bodies_[i].extent, eye_.size); });
  }

  const Eye& eye() const { return eye_; }
  const std::vector<Body>& bodies() const { return bodies_; }

  /// Where the caster's shadow meets a box that is seen.
  Extent met_by(const Reach& reach, const Body& caster) {
    // Where the caster fills much of the picture, or is around the light, a scissor gains little.
    const bool whole =
        reach.planes().empty() || area_of(caster.extent, eye_.size) > eye_.area() / 4;
    Extent met;
    int clipped = 0;
    for (const std::size_t i : largest_first_) {
      Body& body = bodies_[i];
      if (body.shadowed && met.holds(body.extent)) continue;
      if (reach.parts_from(body.crate)) continue;
      const Extent here = whole || ++clipped > most_clipped
                              ? body.extent
                              : common(reach, caster.crate, body, eye_, scratch_);
      if (here.empty() || occlusion_.hides(here)) continue;
      body.shadowed = true;
      met.add(here);
    }
    return met;
  }

  Plan::Why why_dropped(const Reach& reach) {
    if (!view_) return Plan::Why::outside_view;
    for (const Polygon& side : sides_of(*view_)) {
      if (!reach.inside(side, scratch_).empty()) return Plan::Why::meets_nothing;
    }
    return Plan::Why::outside_view;
  }

 private:
  Eye eye_;
  std::vector<Body> bodies_;
  Occlusion occlusion_;
  std::optional<Hexahedron> view_;
  std::vector<std::size_t> largest_first_;  // of what is seen
  Reach::Scratch scratch_;
};

}  // namespace

Plan plan(const scene::Scene& scene, const scene::Camera& camera, glm::dvec4 light,
          glm::ivec2 picture) {
  light = normalized_light(light);
  Planner planner(scene, camera, picture);
  const Eye& eye = planner.eye();
  const std::vector<Body>& bodies = planner.bodies();
  Plan plan;
  Extent all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (!object.casts() || bodies[i].bounds.empty()) continue;
    const Reach reach(bodies[i].crate, light);
    const Extent met = planner.met_by(reach, bodies[i]);
    if (met.empty()) {
      plan.dropped.push_back({i, planner.why_dropped(reach)});
      continue;
    }
    all.add(met);
    plan.casters.push_back(
        {i, apart_from_near_pyramid(camera, eye.aspect, light, bodies[i].bounds, object.model),
         pixels_of(met, eye.size)});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].seen.empty()) plan.seen.push_back(i);
    if (bodies[i].shadowed) plan.shadowed.push_back(i);
  }
  plan.shadows = pixels_of(all, eye.size);
  return plan;
}

}  // namespace shadowlab::shadow
