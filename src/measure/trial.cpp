#include "measure/trial.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

namespace shadowlab::measure {
namespace {

double power_between(Random& random, double low, double high) {
  return std::pow(10, random.between(low, high));
}

bool is_camera(const scene::Camera& camera) {
  const glm::dvec3 sight = camera.target - camera.eye;
  return glm::length(glm::cross(sight, camera.up)) > 1e-3 * glm::length(sight);
}

// The world is unit · (offset + what the trial says).
glm::dvec3 placed(const Trial& trial, glm::dvec3 point) {
  return trial.unit * (trial.offset + point);
}

// A place that a caster makes hard: one of its corners, on an edge, in a face, in a face's plane, a
// little beside a face, or inside.
glm::dvec3 hard_place(const Trial& trial, Random& random) {
  const TrialCaster& caster =
      trial.casters[static_cast<std::size_t>(random.below(static_cast<int>(trial.casters.size())))];
  const scene::Mesh mesh = mesh_of(caster);
  const glm::dmat4 model = model_of(caster);
  const auto triangle =
      static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangle_count())));
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(model * glm::dvec4(mesh.positions[mesh.indices[3 * triangle + i]], 1));
  };
  const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
  const glm::dvec3 middle = (a + b + c) / 3.0, normal = glm::cross(b - a, c - a);
  switch (random.below(6)) {
    case 0:
      return a;
    case 1:
      return (a + b) * 0.5;
    case 2:
      return middle;
    case 3:
      return middle + (b - a) * random.between(-8, 8) + (c - a) * random.between(-8, 8);
    case 4:
      return glm::length(normal) > 0
                 ? middle + glm::normalize(normal) * power_between(random, -4, 0)
                 : middle;
    default:
      return caster.place;
  }
}

void make_view_hard(Trial& trial, Random& random) {
  if (random.chance(0.15)) trial.camera.eye = hard_place(trial, random);
  if (random.chance(0.15)) trial.camera.near = power_between(random, -5, 0.5);
  if (random.chance(0.1)) trial.camera.far = power_between(random, 0.7, 5);
  if (random.chance(0.15))
    trial.camera.fovy = random.chance(0.5) ? random.between(1, 10) : random.between(120, 170);
  if (random.chance(0.1)) {
    trial.width = 24;
    trial.height = 96;
    if (random.chance(0.5)) std::swap(trial.width, trial.height);
  }
  if (random.chance(0.3)) trial.swept = random.unit();
}

void make_light_hard(Trial& trial, Random& random) {
  if (random.chance(0.2)) trial.light = glm::dvec4(hard_place(trial, random), 1);
  if (random.chance(0.1)) {
    trial.light = glm::dvec4(random.direction() * power_between(random, 1, 7), 1);
    if (random.chance(0.5)) trial.light.y = std::abs(trial.light.y);
  }
}

void make_world_hard(Trial& trial, Random& random) {
  if (random.chance(0.15)) {
    // Two of the same, or two in one plane.
    trial.casters.push_back(trial.casters[0]);
    if (random.chance(0.7))
      trial.casters.back().place.x += rounded(random.between(-0.5, 0.5), 0.125);
  }
  if (random.chance(0.25)) trial.unit = std::pow(10, std::round(random.between(-4, 6)));
  if (random.chance(0.2))
    trial.offset = rounded(random.direction() * power_between(random, 3, 6), 1);
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
    list.push_back(next);
    next = trial;
    next.camera.near = std::max(rounded(next.camera.near, step), 0.01);
    list.push_back(next);
    for (std::size_t i = 0; i < trial.casters.size(); ++i) {
      next = trial;
      next.casters[i].place = rounded(next.casters[i].place, step);
      list.push_back(next);
      next = trial;
      next.casters[i].scale = rounded(next.casters[i].scale, step);
      list.push_back(next);
      next = trial;
      next.casters[i].axis = rounded(next.casters[i].axis, step);
      list.push_back(next);
      next = trial;
      next.casters[i].degrees = rounded(next.casters[i].degrees, 90 * step);
      list.push_back(next);
    }
  }
}

void add_simpler_casters(const Trial& trial, std::vector<Trial>& list) {
  for (std::size_t i = 0; i < trial.casters.size(); ++i) {
    for (int shape = 0; shape < static_cast<int>(trial.casters[i].shape); ++shape) {
      list.push_back(trial);
      list.back().casters[i].shape = static_cast<Shape>(shape);
    }
    list.push_back(trial);
    list.back().casters[i].damage = Damage::none;
    list.push_back(trial);
    list.back().casters[i].degrees = 0;
    list.push_back(trial);
    list.back().casters[i].scale = glm::dvec3(1);
    list.push_back(trial);
    list.back().casters[i].scale = glm::abs(trial.casters[i].scale);
  }
}

bool is_trial(const Trial& trial) {
  if (!is_camera(trial.camera) || trial.camera.eye == trial.camera.target) return false;
  if (trial.camera.far <= trial.camera.near) return false;
  if (trial.light.w == 0 && glm::dvec3(trial.light) == glm::dvec3(0)) return false;
  for (const TrialCaster& caster : trial.casters) {
    if (caster.axis == glm::dvec3(0)) return false;
    for (int i = 0; i < 3; ++i) {
      if (caster.scale[i] == 0) return false;
    }
  }
  return true;
}

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
  trial.camera.near = power_between(random, -1.5, 0);
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
  make_view_hard(trial, random);
  make_light_hard(trial, random);
  make_world_hard(trial, random);
  if (!is_camera(trial.camera)) trial.camera.eye += glm::dvec3(0.7, 0.1, 1.3);
  if (trial.camera.far <= trial.camera.near) trial.camera.far = 10 * trial.camera.near;
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
  for (const TrialCaster& caster : trial.casters)
    add(fmt::format("caster {}", scene.objects.size()), mesh_of(caster), world * model_of(caster),
        scene::Role::caster);
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
  next = trial;
  next.width = next.height = 64;
  list.push_back(next);
  next = trial;
  next.swept.reset();
  list.push_back(next);
  next = trial;
  next.camera.far = 60;
  list.push_back(next);
  next = trial;
  next.camera.fovy = 60;
  list.push_back(next);
  add_simpler_casters(trial, list);
  add_rounder(trial, list);
  std::erase_if(list,
                [&](const Trial& one) { return lua_of(one) == lua_of(trial) || !is_trial(one); });
  return list;
}

std::string lua_of(const Trial& trial) {
  std::string casters;
  for (const TrialCaster& caster : trial.casters) casters += "  " + lua_of(caster) + ",\n";
  return fmt::format(
      "{{ unit = {}, offset = {}, light = vec4({}, {}, {}, {}),\n"
      "  camera = {{ eye = {}, target = {}, fovy = {}, near = {}, far = {} }},\n"
      "  size = {{ {}, {} }},{}\n{}}}",
      trial.unit, lua_of(trial.offset), trial.light.x, trial.light.y, trial.light.z, trial.light.w,
      lua_of(trial.camera.eye), lua_of(trial.camera.target), trial.camera.fovy, trial.camera.near,
      trial.camera.far, trial.width, trial.height,
      trial.swept ? fmt::format(" swept = {},", *trial.swept) : "", casters);
}

}  // namespace shadowlab::measure
