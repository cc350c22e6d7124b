#include "truth/traced_scene.h"

#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::truth {
namespace {

glm::dvec3 center_of(const scene::Scene& scene) {
  scene::Bounds bounds;
  for (const scene::Object& object : scene.objects) {
    if (object.mesh) bounds = scene::merge(bounds, scene::bounds(*object.mesh, object.model));
  }
  if (bounds.empty()) return glm::dvec3(0);
  if (!std::isfinite(bounds.radius()) || !std::isfinite(glm::length(bounds.center()))) {
    throw InputError("An object's model matrix puts it at infinity; the truth cannot be traced.");
  }
  const double step = std::exp2(std::ceil(std::log2(std::max(bounds.radius(), 1e-30))) + 1);
  return glm::round(bounds.center() / step) * step;
}

std::vector<Triangle> triangles_of(const scene::Scene& scene, glm::dvec3 center,
                                   bool (*wanted)(const scene::Object&)) {
  std::vector<Triangle> triangles;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    const scene::Object& object = scene.objects[o];
    if (!object.mesh || !wanted(object)) continue;
    const scene::Mesh& mesh = *object.mesh;
    glm::dmat4 model = object.model;
    model[3] -= glm::dvec4(center, 0);
    const auto vertex = [&](std::size_t corner) {
      return glm::dvec3(model * glm::dvec4(mesh.positions[mesh.indices[corner]], 1));
    };
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      triangles.push_back(
          {vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2), o, static_cast<std::uint32_t>(t)});
    }
  }
  return triangles;
}

bool opposite(double p, double q) { return (p < 0 && q > 0) || (p > 0 && q < 0); }

bool same(const Triangle& p, const Triangle& q) {
  return p.object == q.object && p.index == q.index;
}

// Toward the light; the segment ends there unless the light is at infinity.
Segment segment_to(glm::dvec3 from, glm::dvec4 light) {
  if (light.w == 0) return {from, glm::dvec3(light), 0, std::numeric_limits<double>::infinity()};
  return {from, glm::dvec3(light) - from, 0, 1};
}

}  // namespace

View::View(const scene::Camera& camera, glm::dvec3 center, int width, int height)
    : eye(camera.eye - center), near(camera.near), far(camera.far) {
  if (width < 1 || height < 1) {
    throw InputError(fmt::format("A picture of {}x{} has no pixels.", width, height));
  }
  const glm::dmat4 projection = camera.projection(static_cast<double>(width) / height);
  const glm::dmat3 to_world = glm::transpose(glm::dmat3(camera.view()));
  // Window to eye space at unit depth: x_ndc = P00 x_eye - P20 there, and y alike.
  const double left = (-1 + projection[2][0]) / projection[0][0];
  const double top = (1 + projection[2][1]) / projection[1][1];
  top_left_ = to_world * glm::dvec3(left, top, -1);
  step_x_ = to_world * glm::dvec3(2 / (width * projection[0][0]), 0, 0);
  step_y_ = to_world * glm::dvec3(0, -2 / (height * projection[1][1]), 0);
}

glm::dvec3 View::direction(double x, double y) const {
  return top_left_ + x * step_x_ + y * step_y_;
}

TracedScene::TracedScene(const scene::Scene& scene)
    : center_(center_of(scene)),
      all_(triangles_of(scene, center_, [](const scene::Object&) { return true; })) {
  const auto casts = [](const scene::Object& object) { return object.casts(); };
  bool all_cast = true;
  for (const scene::Object& object : scene.objects) all_cast = all_cast && casts(object);
  if (!all_cast) casters_.emplace(triangles_of(scene, center_, casts));
}

std::optional<Hit> TracedScene::first_hit(const View& view, double x, double y) const {
  const glm::dvec3 direction = view.direction(x, y);
  const Line line(view.eye, direction);
  Hit best;
  best.depth = view.far;
  all_.visit({view.eye, direction, view.near, view.far}, [&](const Triangle& triangle) {
    const auto crossing = line.crossing(triangle);
    if (!crossing) return best.depth;
    const double depth = line.parameter(triangle, *crossing);
    if (!(depth >= view.near && depth <= best.depth)) return best.depth;
    // A total order, so that the order in which the tree proposes does not matter.
    if (depth == best.depth && best.triangle != nullptr &&
        std::tie(best.triangle->object, best.triangle->index) <
            std::tie(triangle.object, triangle.index)) {
      return best.depth;
    }
    best = {&triangle, point_at(triangle, *crossing), depth};
    return best.depth;
  });
  if (best.triangle == nullptr) return std::nullopt;
  return best;
}

glm::dvec4 TracedScene::relative(glm::dvec4 light) const {
  if (light.w == 0 && glm::dvec3(light) != glm::dvec3(0)) return light;
  if (!(light.w > 0)) {
    throw InputError("A light must have w > 0, or w = 0 and a direction other than zero.");
  }
  return {glm::dvec3(light) / light.w - center_, 1};
}

bool TracedScene::shadowed(const Hit& hit, glm::dvec3 eye, glm::dvec4 light,
                           const Triangle*& last) const {
  const Segment segment = segment_to(hit.at.point, light);
  if (segment.direction == glm::dvec3(0)) return false;  // the point is the light
  const Line line(segment.origin, segment.direction);
  const auto blocks = [&](const Triangle& triangle) {
    if (!line.crossing(triangle)) return false;
    const double toward = side(triangle, light);
    if (toward == 0) return false;
    double from = 0;
    bool touches = same(triangle, *hit.triangle);
    if (!touches) {
      from = side(triangle, glm::dvec4(hit.at.point, 1));
      touches = on_plane(triangle, hit.at, from);
    }
    if (touches) from = side(triangle, glm::dvec4(eye, 1));
    if (!opposite(from, toward)) return false;
    last = &triangle;
    return true;
  };
  if (last != nullptr && blocks(*last)) return true;
  return casters().any(segment, blocks);
}

bool TracedScene::blocked(glm::dvec3 from, glm::dvec4 light) const {
  const Segment segment = segment_to(from, light);
  if (segment.direction == glm::dvec3(0)) return false;
  const Line line(segment.origin, segment.direction);
  return casters().any(segment, [&](const Triangle& triangle) {
    return line.crossing(triangle) &&
           opposite(side(triangle, glm::dvec4(from, 1)), side(triangle, light));
  });
}

}  // namespace shadowlab::truth
