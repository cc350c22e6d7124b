#include "live/overlay.h"

#include <array>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

#include "core/error.h"
#include "scene/adjacency.h"
#include "shadow/cascades.h"
#include "shadow/light_view.h"
#include "shadow/silhouette.h"

namespace shadowlab::live {
namespace {

constexpr int shown_cascades = 4;

scene::Bounds bounds_of(const scene::Scene& scene) {
  scene::Bounds bounds;
  for (const auto& object : scene.objects)
    bounds = merge(bounds, scene::bounds(*object.mesh, object.model));
  return bounds;
}

// Away from the light, far enough to leave the scene.
glm::dvec3 extruded(glm::dvec3 point, glm::dvec4 light, double reach) {
  const glm::dvec3 away = point * light.w - glm::dvec3(light);
  const double length = glm::length(away);
  return length > 0 ? point + away * (reach / length) : point;
}

std::vector<Shape> edges(const scene::Scene& scene, glm::dvec4 light, Overlay overlay) {
  std::vector<Shape> shapes;
  const double reach = 4 * bounds_of(scene).radius();
  for (const scene::Object& object : scene.objects) {
    if (!object.casts()) continue;
    const scene::Adjacency mesh = scene::adjacency(*object.mesh);
    const glm::dvec4 own_light = glm::inverse(object.model) * light;
    const auto world = [&](std::uint32_t vertex) {
      return glm::dvec3(object.model * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1));
    };
    for (const auto& edge : shadow::silhouette(mesh, own_light)) {
      const glm::dvec3 a = world(edge.a), b = world(edge.b);
      shapes.push_back({Shape::Kind::line, {a, b}, 0});
      if (overlay == Overlay::volumes) {
        shapes.push_back(
            {Shape::Kind::face, {a, b, extruded(b, light, reach), extruded(a, light, reach)}, 0});
      }
    }
  }
  return shapes;
}

void add_frustum(std::vector<Shape>& shapes, const shadow::LightView& view, int group) {
  const glm::dmat4 back = glm::inverse(view.projection * view.view);
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4 corner = back * glm::dvec4(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1, 1);
    corners[i] = glm::dvec3(corner) / corner.w;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const std::size_t bit : {1u, 2u, 4u}) {
      if (!(i & bit)) shapes.push_back({Shape::Kind::line, {corners[i], corners[i | bit]}, group});
    }
  }
}

}  // namespace

const char* name_of(Overlay overlay) {
  switch (overlay) {
    case Overlay::silhouettes:
      return "silhouettes";
    case Overlay::volumes:
      return "shadow volumes";
    case Overlay::frustum:
      return "light frustum";
    case Overlay::cascades:
      return "cascades";
    default:
      return "nothing";
  }
}

std::vector<Shape> shapes(Overlay overlay, const scene::Scene& scene, const scene::Camera& camera,
                          double aspect, glm::dvec4 light) {
  std::vector<Shape> shapes;
  try {
    switch (overlay) {
      case Overlay::silhouettes:
      case Overlay::volumes:
        return edges(scene, light, overlay);
      case Overlay::frustum:
        add_frustum(
            shapes,
            shadow::light_view(light, scene, shadow::content_in_view(scene, camera, aspect)), 0);
        break;
      case Overlay::cascades: {
        const auto all = shadow::cascades(scene, camera, aspect, light, shown_cascades,
                                          {camera.near, camera.far}, {});
        for (std::size_t i = 0; i < all.size(); ++i)
          add_frustum(shapes, all[i].light, static_cast<int>(i));
        break;
      }
      default:
        break;
    }
  } catch (const InputError&) {
    // The light has no such view: it stands in the scene, or in a face.
    return {};
  }
  return shapes;
}

const std::vector<Shape>& OverlayShapes::of(Overlay overlay, const scene::Scene& scene,
                                            const scene::Camera& camera, double aspect,
                                            glm::dvec4 light) {
  MadeOf now{overlay, {camera.fovy, camera.near, camera.far, aspect}, {}};
  const auto add = [&](const auto& vector) {
    for (glm::length_t i = 0; i < vector.length(); ++i) now.numbers.push_back(vector[i]);
  };
  add(camera.eye);
  add(camera.target);
  add(camera.up);
  add(light);
  for (const scene::Object& object : scene.objects) {
    for (glm::length_t column = 0; column < 4; ++column) add(object.model[column]);
    now.numbers.push_back(static_cast<double>(object.role));
    now.meshes.push_back(object.mesh);
  }
  if (now != made_of_) {
    shapes_ = shapes(overlay, scene, camera, aspect, light);
    made_of_ = std::move(now);
  }
  return shapes_;
}

std::vector<glm::dvec2> projected(const Shape& shape, const scene::Camera& camera, double aspect) {
  const std::size_t count = shape.points.size();
  const bool closed = shape.kind == Shape::Kind::face;
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const auto beyond = [&](glm::dvec3 point) {
    return glm::dot(point - camera.eye, forward) - camera.near;
  };
  std::vector<glm::dvec2> picture;
  const auto put = [&](glm::dvec3 point) {
    const Seen place = seen(camera, aspect, point);
    picture.emplace_back(place.x, place.y);
  };
  // Sutherland and Hodgman, Reentrant Polygon Clipping, 1974, for the one plane.
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 here = shape.points[i];
    const double d = beyond(here);
    if (d >= 0) put(here);
    if (!closed && i + 1 == count) break;
    const glm::dvec3 next = shape.points[(i + 1) % count];
    const double e = beyond(next);
    if ((d < 0) != (e < 0)) put(glm::mix(here, next, d / (d - e)));
  }
  if (picture.size() < (closed ? 3u : 2u)) picture.clear();
  return picture;
}

}  // namespace shadowlab::live
