#include "measure/trial.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "measure/random.h"

namespace shadowlab::measure {
namespace {

struct ShapeName {
  Shape shape;
  const char* lua;
};
constexpr std::array shapes{ShapeName{Shape::box, "mesh.box(1)"},
                            ShapeName{Shape::tetrahedron, "mesh.tetrahedron(0.6)"},
                            ShapeName{Shape::sphere, "mesh.sphere(0.5, 12, 7)"},
                            ShapeName{Shape::torus, "mesh.torus(0.5, 0.2, 12, 6)"},
                            ShapeName{Shape::teapot, "mesh.teapot(1, 3)"},
                            ShapeName{Shape::sheet, "mesh.plane(1, 1, 2, 2)"},
                            ShapeName{Shape::sliver, "mesh.plane(1, 1e-4)"}};

scene::Mesh mesh_of(Shape shape) {
  switch (shape) {
    case Shape::tetrahedron:
      return scene::tetrahedron(0.6);
    case Shape::sphere:
      return scene::sphere(0.5, 12, 7);
    case Shape::torus:
      return scene::torus(0.5, 0.2, 12, 6);
    case Shape::teapot:
      return scene::teapot(1, 3);
    case Shape::sheet:
      return scene::plane(1, 1, 2, 2);
    case Shape::sliver:
      return scene::plane(1, 1e-4);
    default:
      return scene::box();
  }
}

// To so many binary places, so that sums are exact.
double rounded(double value, double step) { return std::round(value / step) * step; }
glm::dvec3 rounded(glm::dvec3 v, double step) {
  return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)};
}

TrialCaster caster_of(Random& random, bool round) {
  TrialCaster caster;
  caster.shape = static_cast<Shape>(random.below(static_cast<int>(Shape::count)));
  caster.place = {random.between(-1.5, 1.5), random.between(0.1, 2.2), random.between(-1.5, 1.5)};
  caster.axis = random.direction();
  caster.degrees = random.between(0, 360);
  for (int i = 0; i < 3; ++i) caster.scale[i] = std::pow(10, random.between(-2.5, 0.5));
  if (random.chance(0.6)) caster.scale = glm::dvec3(random.between(0.3, 1.5));
  if (round) {
    caster.place = rounded(caster.place, 0.25);
    caster.degrees = rounded(caster.degrees, 90);
    caster.axis = {0, 1, 0};
    caster.scale = glm::max(rounded(caster.scale, 0.25), glm::dvec3(0.25));
  }
  return caster;
}

bool is_camera(const scene::Camera& camera) {
  const glm::dvec3 sight = camera.target - camera.eye;
  return glm::length(glm::cross(sight, camera.up)) > 1e-3 * glm::length(sight);
}

// The world is unit · (offset + what the trial says).
glm::dvec3 placed(const Trial& trial, glm::dvec3 point) {
  return trial.unit * (trial.offset + point);
}

void add_rounder(const Trial& trial, std::vector<Trial>& list) {
  for (const double step : {1.0, 0.5, 0.25, 0.125, 0.01}) {
    Trial next = trial;
    next.camera.eye = rounded(next.camera.eye, step);
    list.push_back(next);
    next = trial;
    next.camera.target = rounded(next.camera.target, step);
    list.push_back(next);
    next = trial;
    next.light = glm::dvec4(rounded(glm::dvec3(next.light), step), next.light.w);
    if (glm::dvec3(next.light) != glm::dvec3(0)) list.push_back(next);
    next = trial;
    next.camera.near = std::max(rounded(next.camera.near, step), 0.01);
    list.push_back(next);
    for (std::size_t i = 0; i < trial.casters.size(); ++i) {
      next = trial;
      next.casters[i].place = rounded(next.casters[i].place, step);
      list.push_back(next);
      next = trial;
      next.casters[i].scale = glm::max(rounded(next.casters[i].scale, step), glm::dvec3(1e-3));
      list.push_back(next);
      next = trial;
      next.casters[i].axis = rounded(next.casters[i].axis, step);
      if (next.casters[i].axis != glm::dvec3(0)) list.push_back(next);
      next = trial;
      next.casters[i].degrees = rounded(next.casters[i].degrees, 90 * step);
      list.push_back(next);
    }
  }
}

bool same(const Trial& a, const Trial& b) { return lua_of(a) == lua_of(b); }

std::string text(glm::dvec3 v) { return fmt::format("vec3({}, {}, {})", v.x, v.y, v.z); }

}  // namespace

Trial trial_of(std::uint64_t seed, std::uint64_t index) {
  Random random(seed * 1'000'003 + index);
  const bool round = random.chance(0.5);
  Trial trial;
  const int count = 1 + random.below(3);
  for (int i = 0; i < count; ++i) trial.casters.push_back(caster_of(random, round));
  trial.camera.eye = random.direction() * random.between(0.3, 6) + glm::dvec3(0, 1, 0);
  trial.camera.target = random.direction() * random.between(0, 1) + glm::dvec3(0, 0.7, 0);
  trial.camera.up = {0, 1, 0};
  trial.camera.fovy = random.between(10, 130);
  trial.camera.near = std::pow(10, random.between(-1.5, 0));
  trial.camera.far = 60;
  const glm::dvec3 toward = random.direction();
  trial.light = random.chance(0.3)
                    ? glm::dvec4(toward, 0)
                    : glm::dvec4(toward * random.between(0.3, 6) + glm::dvec3(0, 1, 0), 1);
  if (round) {
    trial.camera.eye = rounded(trial.camera.eye, 0.25);
    trial.camera.target = rounded(trial.camera.target, 0.25);
    trial.light = glm::dvec4(rounded(glm::dvec3(trial.light), 0.25), trial.light.w);
    if (glm::dvec3(trial.light) == glm::dvec3(0)) trial.light.y = 1;
  }
  if (!is_camera(trial.camera)) trial.camera.eye += glm::dvec3(0.7, 0.1, 1.3);
  if (random.chance(0.25)) trial.unit = std::pow(10, std::round(random.between(-3, 3)));
  if (random.chance(0.2)) trial.offset = rounded(random.direction() * 1e3, 1);
  return trial;
}

scene::Scene scene_of(const Trial& trial) {
  scene::Scene scene;
  scene.name = "trial";
  const auto add = [&](std::string name, scene::Mesh mesh, const glm::dmat4& model,
                       scene::Role role) {
    scene::Object object;
    object.name = std::move(name);
    object.mesh = std::make_shared<scene::Mesh>(std::move(mesh));
    object.model = model;
    object.role = role;
    scene.objects.push_back(std::move(object));
  };
  const glm::dmat4 world = glm::scale(glm::dmat4(1), glm::dvec3(trial.unit)) *
                           glm::translate(glm::dmat4(1), trial.offset);
  add("floor", scene::plane(12, 12), world, scene::Role::receiver);
  for (const TrialCaster& caster : trial.casters) {
    add(fmt::format("caster {}", scene.objects.size()), mesh_of(caster.shape),
        world * glm::translate(glm::dmat4(1), caster.place) *
            glm::rotate(glm::dmat4(1), glm::radians(caster.degrees), caster.axis) *
            glm::scale(glm::dmat4(1), caster.scale),
        scene::Role::caster);
  }
  scene.camera = trial.camera;
  scene.camera.eye = placed(trial, trial.camera.eye);
  scene.camera.target = placed(trial, trial.camera.target);
  scene.camera.near *= trial.unit;
  scene.camera.far *= trial.unit;
  scene.lights.emplace_back();
  scene.lights[0].position =
      trial.light.w == 0 ? trial.light : glm::dvec4(placed(trial, glm::dvec3(trial.light)), 1);
  return scene;
}

std::vector<Trial> simpler(const Trial& trial) {
  std::vector<Trial> list;
  for (std::size_t i = 0; trial.casters.size() > 1 && i < trial.casters.size(); ++i) {
    list.push_back(trial);
    list.back().casters.erase(list.back().casters.begin() + static_cast<std::ptrdiff_t>(i));
  }
  Trial next = trial;
  next.offset = glm::dvec3(0);
  list.push_back(next);
  next = trial;
  next.unit = 1;
  list.push_back(next);
  for (std::size_t i = 0; i < trial.casters.size(); ++i) {
    for (int shape = 0; shape < static_cast<int>(trial.casters[i].shape); ++shape) {
      list.push_back(trial);
      list.back().casters[i].shape = static_cast<Shape>(shape);
    }
    list.push_back(trial);
    list.back().casters[i].degrees = 0;
    list.push_back(trial);
    list.back().casters[i].scale = glm::dvec3(1);
  }
  next = trial;
  next.camera.fovy = 60;
  list.push_back(next);
  add_rounder(trial, list);
  std::erase_if(list, [&](const Trial& one) {
    return same(one, trial) || !is_camera(one.camera) || one.camera.eye == one.camera.target;
  });
  return list;
}

std::string lua_of(const Trial& trial) {
  std::string casters;
  for (const TrialCaster& caster : trial.casters) {
    casters += fmt::format("  {{ {}, {}, {}, {}, {} }},\n",
                           shapes[static_cast<std::size_t>(caster.shape)].lua, text(caster.place),
                           text(caster.axis), caster.degrees, text(caster.scale));
  }
  return fmt::format(
      "{{ unit = {}, offset = {}, light = vec4({}, {}, {}, {}),\n"
      "  camera = {{ eye = {}, target = {}, fovy = {}, near = {}, far = {} }},\n{}}}",
      trial.unit, text(trial.offset), trial.light.x, trial.light.y, trial.light.z, trial.light.w,
      text(trial.camera.eye), text(trial.camera.target), trial.camera.fovy, trial.camera.near,
      trial.camera.far, casters);
}

}  // namespace shadowlab::measure
