#include "measure/bar_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/mesh.h"
#include "truth/closed_forms.h"
#include "truth/tracer.h"

namespace shadowlab::measure {
namespace {

constexpr double light_height = 4, light_half = 0.5;

scene::Object object(const char* name, scene::Mesh mesh, double height, scene::Role role) {
  scene::Object made;
  made.name = name;
  made.mesh = std::make_shared<scene::Mesh>(std::move(mesh));
  made.model[3] = {0, height, 0, 1};
  made.role = role;
  return made;
}

// A fan: its polygon's area is the disk's but for (2π/n)²/6, 1e-5 at this n.
scene::Mesh disk(double radius) {
  constexpr int sides = 800;
  scene::Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (int i = 0; i < sides; ++i) {
    const double t = 2 * 3.141592653589793 * i / sides;
    mesh.positions.push_back(glm::vec3(glm::dvec3(radius * std::cos(t), 0, radius * std::sin(t))));
    mesh.indices.insert(mesh.indices.end(), {0u, static_cast<std::uint32_t>((i + 1) % sides + 1),
                                             static_cast<std::uint32_t>(i + 1)});
  }
  mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
  return mesh;
}

struct Case {
  std::string shadow;
  scene::Mesh caster;
  double height;
  scene::Light light;
  std::function<double(glm::dvec3)> expected;
};

BarCheck check(const Case& known, double bar, int size) {
  scene::Scene scene;
  scene.objects.push_back(object("floor", scene::plane(8, 8), 0, scene::Role::receiver));
  scene.objects.push_back(object("caster", known.caster, known.height, scene::Role::caster));
  // From below the caster, so that nothing but the floor is seen.
  scene.camera.eye = {0.05, 0.9 * known.height, 0.03};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  scene.camera.fovy = 110;
  scene.camera.near = 0.01;
  const truth::Tracer tracer(scene);
  truth::Sampling sampling;
  sampling.samples = 1 << 14;
  sampling.error = bar;
  const auto traced = tracer.soft_visibility(scene.camera, known.light, size, size, sampling);
  const auto surfaces = tracer.surfaces(scene.camera, size, size);
  BarCheck result{.shadow = known.shadow, .bar = bar};
  double squares = 0;
  std::size_t one = 0, three = 0;
  for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
    if (surfaces.surfaces[i].object != 0) continue;
    const double expected = known.expected(surfaces.surfaces[i].point);
    if (expected <= 0 || expected >= 1) continue;
    const double off = std::abs(double{traced.visibility.values[i]} - expected);
    ++result.pixels;
    squares += off * off;
    one += off <= bar;
    three += off <= 3 * bar;
    result.worst = std::max(result.worst, off);
  }
  const auto pixels = static_cast<double>(std::max<std::size_t>(result.pixels, 1));
  result.rmse = std::sqrt(squares / pixels);
  result.within_one = static_cast<double>(one) / pixels;
  result.within_three = static_cast<double>(three) / pixels;
  result.samples = static_cast<double>(traced.rays) / (double(size) * double(size));
  result.unconverged = traced.unconverged;
  return result;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  scene::Light square;
  square.position = {0, light_height, 0, 1};
  square.shape = scene::Light::Shape::rectangle;
  square.half_u = {light_half, 0, 0};
  square.half_v = {0, 0, light_half};
  scene::Light round = square;
  round.shape = scene::Light::Shape::disk;
  for (const double height : {0.5, 1.5, 3.0}) {
    const truth::Heights heights{height, light_height};
    const glm::dvec2 half{0.45, 0.3};
    all.push_back({"a rectangle under a square light", scene::plane(2 * half.x, 2 * half.y), height,
                   square, [=](glm::dvec3 p) {
                     return truth::rectangle_under_rectangle({p.x, p.z}, -half, half, {0, 0},
                                                             {light_half, light_half}, heights);
                   }});
    all.push_back({"a disk under a disk light", disk(0.4), height, round, [=](glm::dvec3 p) {
                     return truth::disk_under_disk(glm::length(glm::dvec2(p.x, p.z)), 0.4,
                                                   light_half, heights);
                   }});
  }
  return all;
}

}  // namespace

std::vector<BarCheck> check_bar(double bar, int size) {
  std::vector<BarCheck> checks;
  for (const Case& known : cases()) {
    BarCheck row = check(known, bar, size);
    row.shadow += ", the caster at " + fmt::format("{}", known.height / light_height) +
                  " of the light's height";
    checks.push_back(std::move(row));
  }
  return checks;
}

Json record_of(const BarCheck& check) {
  return {{"shadow", check.shadow},
          {"bar", check.bar},
          {"pixels", check.pixels},
          {"rmse", check.rmse},
          {"within_one", check.within_one},
          {"within_three", check.within_three},
          {"worst", check.worst},
          {"samples", check.samples},
          {"unconverged", check.unconverged},
          {"holds", check.holds()}};
}

}  // namespace shadowlab::measure
