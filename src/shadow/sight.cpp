#include "shadow/sight.h"

#include "shadow/back.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shadowlab::shadow {
namespace {

// Bodies that a caster is held against exactly; of more it is said to meet all that may be met.
constexpr int most_clipped = 4;

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
    bodies[i].room = 1e-6 * reach + eye.tolerance(bodies[i].farthest);
    bodies[i].crate = crate_around(bodies[i].bounds, scene.objects[i].model, bodies[i].room);
    bodies[i].farthest += 2 * bodies[i].room;
  }
  return bodies;
}

// The view between two distances, a pixel wider on each side.
Hexahedron view_between(const scene::Camera& camera, const Eye& eye, double near, double far) {
  const glm::dvec2 wider = 1.0 + 2.0 / eye.size;
  scene::Camera wide = camera;
  wide.fovy = glm::degrees(2 * std::atan(eye.slope * wider.y));
  return frustum(wide, eye.aspect * wider.x / wider.y, near, far);
}

// All of it, to beyond the farthest body; nothing where all are behind.
std::optional<Hexahedron> view_of(const scene::Camera& camera, const Eye& eye,
                                  const std::vector<Body>& bodies) {
  double farthest = 0;
  for (const Body& body : bodies) farthest = std::max(farthest, body.farthest);
  if (farthest <= eye.near) return {};
  return view_between(camera, eye, eye.near * (1 - 1e-6), 2 * farthest);
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

double area_of(const Extent& extent, glm::dvec2 size) {
  const PixelSpan pixels = pixels_of(extent, size);
  const glm::dvec2 sides(pixels.last - pixels.first);
  return sides.x * sides.y;
}

// A side of a body that fills its box: four corners in order around it, and the way out, not of
// unit length.
struct Side {
  std::array<std::size_t, 4> corners;
  glm::dvec3 outward;
};
std::array<Side, 6> sides_of(const Body& body) {
  std::array<Side, 6> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t k = std::size_t{1} << axis, u = std::size_t{1} << (axis + 1) % 3,
                      v = std::size_t{1} << (axis + 2) % 3;
    for (const std::size_t side : {std::size_t{0}, k}) {
      const auto at = [&](std::size_t corner) { return body.corners[corner]; };
      glm::dvec3 normal = glm::cross(at(u) - at(0), at(v) - at(0));
      if (glm::dot(normal, at(side) - at(side ^ k)) < 0) normal = -normal;
      sides[2 * axis + (side ? 1 : 0)] = {{side, side | u, side | u | v, side | v}, normal};
    }
  }
  return sides;
}

// A whole box hides what is behind it.
void hide_behind(const Body& body, const Eye& eye, Occlusion& occlusion) {
  std::array<glm::dvec2, 8> pixels;
  for (std::size_t i = 0; i < 8; ++i) pixels[i] = eye.pixel(body.corners[i]);
  double farthest = 0;  // of the faces that are turned to the eye
  for (const Side& side : sides_of(body)) {
    if (glm::dot(side.outward, eye.position - body.corners[side.corners[0]]) <= 0) continue;
    for (const std::size_t corner : side.corners)
      farthest = std::max(farthest, eye.depth(body.corners[corner]));
  }
  if (farthest > 0) occlusion.add(pixels, farthest);
}

// How wide a side is where it is narrowest, pixels; negative where it is turned from the eye.
double width_seen(const Body& body, const Side& side, const Eye& eye) {
  std::array<glm::dvec2, 4> at;
  double longest = 0, twice_area = 0;
  for (std::size_t i = 0; i < 4; ++i) at[i] = eye.pixel(body.corners[side.corners[i]]);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 a = at[i], b = at[(i + 1) % 4];
    twice_area += a.x * b.y - a.y * b.x;
    longest = std::max({longest, glm::length(b - a), glm::length(at[(i + 2) % 4] - a)});
  }
  const double width = std::abs(twice_area) / 2 / std::max(longest, 1e-300);
  const bool toward = glm::dot(side.outward, eye.position - body.corners[side.corners[0]]) > 0;
  return toward ? width : -width;
}

// The sine of how high the light stands over a side, where it stands lowest; negative below it.
double height_of_light(const Body& body, const Side& side, glm::dvec4 light) {
  double lowest = 1;
  bool above = true;
  for (const std::size_t corner : side.corners) {
    const glm::dvec3 way = glm::dvec3(light) - light.w * body.corners[corner];
    const double height = glm::dot(glm::normalize(side.outward), glm::normalize(way));
    lowest = std::min(lowest, std::abs(height));
    above = height > 0;
  }
  return above ? lowest : -lowest;
}

// What is less is not told apart from edge on: corners are moved by 1/512 of a pixel, and lights in
// model space are floats.
constexpr double least_width = 1.0 / 16, least_height = 1e-4;

Occlusion occlusion_of(const std::vector<Body>& bodies, const Eye& eye) {
  Occlusion occlusion{glm::ivec2(eye.size)};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].whole_box && !bodies[i].seen.empty()) hide_behind(bodies[i], eye, occlusion);
  }
  return occlusion;
}

// Which bodies are boxes before the near plane.
void find_whole_boxes(const scene::Scene& scene, const Eye& eye, std::vector<Body>& bodies) {
  struct Shape {
    bool filled = false, solid = false;
  };
  std::map<const scene::Mesh*, Shape> shapes;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies[i];
    if (body.bounds.empty()) continue;
    const scene::Mesh* mesh = scene.objects[i].mesh.get();
    const auto [known, is_new] = shapes.try_emplace(mesh);
    if (is_new && fills_its_box(*mesh)) known->second = {true, is_turned_out(*mesh)};
    if (!known->second.filled) continue;
    double nearest = 1e300;
    for (std::size_t c = 0; c < 8; ++c)
      nearest = std::min(nearest, eye.depth(body.crate.corner(c)));
    body.whole_box = nearest >= eye.near * (1 + 1e-6);
    // Under any projection that has this near plane.
    body.hides_back = known->second.solid && nearest >= eye.near * (1 + 1e-4) &&
                      glm::determinant(glm::dmat3(scene.objects[i].model)) > 0;
    for (std::size_t c = 0; c < 8; ++c) {
      const scene::Bounds& box = body.bounds;
      const glm::dvec3 corner((c & 1) ? box.high.x : box.low.x, (c & 2) ? box.high.y : box.low.y,
                              (c & 4) ? box.high.z : box.low.z);
      body.corners[c] = glm::dvec3(scene.objects[i].model * glm::dvec4(corner, 1));
    }
  }
}

// Those of the crate's corners that are before all planes and the near plane.
void add_corners_within(const Crate& crate, const Planes& planes, const Eye& eye, Extent& extent) {
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 corner(crate.corner(i), 1);
    const double depth = eye.depth(corner);
    if (depth < eye.near) continue;
    const auto before = [&](const glm::dvec4& plane) { return glm::dot(plane, corner) >= 0; };
    if (std::ranges::all_of(planes, before)) extent.add(eye.pixel(corner), depth);
  }
}

// What of a body the camera sees inside the reach. A body that the reach goes into has a part of
// its surface inside: the reach is convex and has no end, the body has one. With the caster's
// corners in the body these are all the corners of what they have in common.
Extent common(const ShadowReach& reach, const Crate& caster, const Body& body, const Eye& eye,
              ClipScratch& scratch) {
  Extent here;
  for (const Polygon& side : body.seen) {
    for (const glm::dvec3& corner : reach.inside(side, scratch))
      here.add(eye.pixel(corner), eye.depth(corner));
  }
  if (!here.empty()) add_corners_within(caster, hexahedron(body.crate).planes, eye, here);
  return here;
}

// Sets what of the body the camera sees in the view.
void look_at(Body& body, const Hexahedron& view, const Eye& eye) {
  body.extent = {};
  body.seen = seen_of(body.crate, view);
  for (const Polygon& side : body.seen) {
    for (const glm::dvec3& corner : side) body.extent.add(eye.pixel(corner), eye.depth(corner));
  }
}

}  // namespace

Eye::Eye(const scene::Camera& camera, glm::ivec2 picture)
    : position(camera.eye),
      view(camera.view()),
      size(picture),
      slope(std::tan(glm::radians(camera.fovy) / 2)),
      aspect(double(picture.x) / double(picture.y)),
      near(camera.near) {}

double Eye::tolerance(double z) const {
  z = std::max(z, near);
  return z * slope * 2 / size.y / 32 + 12 * z * z / (near * 0x1p24);
}

glm::dvec2 Eye::pixel(glm::dvec3 point) const {
  const glm::dvec4 p = view * glm::dvec4(point, 1);
  const double scale = 1 / (std::max(-p.z, near) * slope);
  return {(p.x * scale / aspect + 1) / 2 * size.x, (p.y * scale + 1) / 2 * size.y};
}

PixelSpan pixels_of(const Extent& extent, glm::dvec2 size) {
  if (extent.empty()) return {};
  return {glm::ivec2(glm::clamp(glm::floor(extent.low) - 1.0, glm::dvec2(0), size)),
          glm::ivec2(glm::clamp(glm::ceil(extent.high) + 1.0, glm::dvec2(0), size))};
}

Sight::Sight(const scene::Scene& scene, const scene::Camera& camera, glm::ivec2 picture)
    : camera_(camera), eye_(camera, picture), bodies_(bodies_of(scene, eye_)) {
  view_ = view_of(camera, eye_, bodies_);
  if (!view_) return;
  view_sides_ = sides_of(*view_);
  find_whole_boxes(scene, eye_, bodies_);
  for (Body& body : bodies_) {
    if (!body.bounds.empty()) look_at(body, *view_, eye_);
  }
  occlusion_.emplace(occlusion_of(bodies_, eye_));
  sort_seen();
}

// Forgets what is hidden, and lists the rest.
void Sight::sort_seen() {
  largest_first_.clear();
  all_seen_ = {};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    if (!body.seen.empty() && occlusion_->hides(body.extent)) {
      body.seen.clear();
      body.extent = {};
    }
    if (body.seen.empty()) continue;
    largest_first_.push_back(i);
    all_seen_.add(body.extent);
  }
  unshadowed_ = largest_first_.size();
  std::ranges::stable_sort(largest_first_, std::greater{},
                           [&](std::size_t i) { return area_of(bodies_[i].extent, eye_.size); });
}

void Sight::narrow(const std::optional<DepthRange>& part,
                   const std::function<bool(const Crate&)>& wanted) {
  if (!view_) return;
  const Hexahedron view = part ? view_between(camera_, eye_, part->near, part->far) : *view_;
  for (Body& body : bodies_) {
    if (body.seen.empty()) continue;
    if (part) look_at(body, view, eye_);
    if (!wanted(body.crate)) body.seen.clear();
  }
  sort_seen();
}

std::optional<bool> Sight::shows_unlit_side(std::size_t caster, glm::dvec4 light) const {
  const Body& body = bodies_[caster];
  if (!body.hides_back) return {};
  bool shown = false;
  for (const Side& side : sides_of(body)) {
    const double width = width_seen(body, side, eye_), height = height_of_light(body, side, light);
    // (A comparison with what is no number is false: then nothing is said.)
    if (!(std::abs(width) >= least_width && std::abs(height) >= least_height)) return {};
    shown = shown || (width > 0 && height < 0);
  }
  return shown;
}

Extent Sight::met_itself(std::size_t caster) {
  Body& body = bodies_[caster];
  if (body.seen.empty()) return {};
  unshadowed_ -= body.shadowed ? 0 : 1;
  body.shadowed = true;
  return body.extent;
}

Extent Sight::met_by(const ShadowReach& reach, std::size_t caster, Itself itself) {
  // Where the caster or its shadow fills much of the picture, or the light is in it, a scissor
  // gains little.
  const auto is_much = [&](const Extent& extent) {
    return area_of(extent, eye_.size) > eye_.area() / 4;
  };
  bool whole = reach.planes().empty() || is_much(bodies_[caster].extent);
  Extent met;
  int clipped = 0;
  for (const std::size_t i : largest_first_) {
    if (unshadowed_ == 0 && met.holds(all_seen_)) break;
    if (i == caster && itself == Itself::left_out) continue;
    Body& body = bodies_[i];
    if (body.shadowed && met.holds(body.extent)) continue;
    if (reach.parts_from(body.crate)) continue;
    const Extent here = whole || reach.holds(body.crate) || ++clipped > most_clipped
                            ? body.extent
                            : common(reach, bodies_[caster].crate, body, eye_, scratch_);
    if (here.empty() || occlusion_->hides(here)) continue;
    unshadowed_ -= body.shadowed ? 0 : 1;
    body.shadowed = true;
    met.add(here);
    whole = whole || is_much(met);
  }
  return met;
}

bool Sight::is_met_by(const ShadowReach& reach, const Crate& caster) {
  return std::ranges::any_of(largest_first_, [&](std::size_t i) {
    const Body& body = bodies_[i];
    if (reach.parts_from(body.crate)) return false;
    const Extent here = common(reach, caster, body, eye_, scratch_);
    return !here.empty() && !occlusion_->hides(here);
  });
}

// The corners of what the reach and the view have in common are on the view's sides, or are the
// caster's: others the reach has not.
Extent Sight::covered_by(const ShadowReach& reach, std::size_t caster) {
  Extent covered;
  if (!view_) return covered;
  for (const Polygon& side : view_sides_) {
    for (const glm::dvec3& corner : reach.inside(side, scratch_))
      covered.add(eye_.pixel(corner), eye_.depth(corner));
  }
  if (covered.empty()) return covered;
  add_corners_within(bodies_[caster].crate, view_->planes, eye_, covered);
  return covered;
}

}  // namespace shadowlab::shadow
