#include "measure/trial_caster.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace shadowlab::measure {
namespace {

constexpr std::array shapes{"mesh.box(1)",
                            "mesh.tetrahedron(0.6)",
                            "mesh.sphere(0.5, 12, 7)",
                            "mesh.torus(0.5, 0.2, 12, 6)",
                            "mesh.teapot(1, 3)",
                            "mesh.plane(1, 1, 2, 2)",
                            "mesh.plane(1, 1e-4)"};
constexpr std::array damages{"none",   "twice", "reversed", "mixed",
                             "opened", "split", "finned",   "needles"};
static_assert(shapes.size() == static_cast<std::size_t>(Shape::count));
static_assert(damages.size() == static_cast<std::size_t>(Damage::count));

scene::Mesh whole(Shape shape) {
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

// The same positions without normals, whose triangles are made one by one.
class Broken {
 public:
  explicit Broken(const scene::Mesh& from) { mesh_.positions = from.positions; }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }
  std::uint32_t add(glm::vec3 position) {
    mesh_.positions.push_back(position);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  glm::vec3 operator[](std::uint32_t i) const { return mesh_.positions[i]; }
  scene::Mesh mesh() && {
    scene::compute_normals(mesh_);
    return std::move(mesh_);
  }

 private:
  scene::Mesh mesh_;
};

scene::Mesh broken(const scene::Mesh& from, Damage damage) {
  Broken to(from);
  for (std::size_t t = 0; t < from.triangle_count(); ++t) {
    const std::uint32_t a = from.indices[3 * t], b = from.indices[3 * t + 1],
                        c = from.indices[3 * t + 2];
    const bool turned = damage == Damage::reversed || (damage == Damage::mixed && t % 2 == 1);
    if (damage == Damage::opened && t % 3 == 2) continue;
    if (damage == Damage::split && t % 2 == 0) {
      const std::uint32_t middle = to.add((to[a] + to[b]) * 0.5f);
      to.add(a, middle, c);
      to.add(middle, b, c);
      continue;
    }
    turned ? to.add(b, a, c) : to.add(a, b, c);
    if (damage == Damage::twice) to.add(a, b, c);
    if (damage == Damage::finned && t % 3 == 0) to.add(b, a, to.add(to[a] + to[b] - to[c]));
    if (damage == Damage::needles) {
      to.add(a, to.add((to[a] + to[b]) * 0.5f), b);
      to.add(c, c, a);
    }
  }
  return std::move(to).mesh();
}

}  // namespace

scene::Mesh mesh_of(const TrialCaster& caster) {
  scene::Mesh mesh = whole(caster.shape);
  return caster.damage == Damage::none ? mesh : broken(mesh, caster.damage);
}

glm::dmat4 model_of(const TrialCaster& caster) {
  return glm::translate(glm::dmat4(1), caster.place) *
         glm::rotate(glm::dmat4(1), glm::radians(caster.degrees), caster.axis) *
         glm::scale(glm::dmat4(1), caster.scale);
}

double rounded(double value, double step) { return std::round(value / step) * step; }
glm::dvec3 rounded(glm::dvec3 v, double step) {
  return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)};
}

TrialCaster caster_of(Random& random, bool round) {
  TrialCaster caster;
  caster.shape = static_cast<Shape>(random.below(static_cast<int>(Shape::count)));
  if (random.chance(0.3))
    caster.damage = static_cast<Damage>(random.below(static_cast<int>(Damage::count)));
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
  if (random.chance(0.2)) {
    // It stands on the floor, or lies in it.
    caster.axis = {0, 1, 0};
    caster.place.y = random.chance(0.3) ? 0 : caster.scale.y / 2;
  }
  if (random.chance(0.05)) caster.scale[random.below(3)] *= -1;
  return caster;
}

std::string lua_of(glm::dvec3 v) { return fmt::format("vec3({}, {}, {})", v.x, v.y, v.z); }

std::string lua_of(const TrialCaster& caster) {
  return fmt::format("{{ {}, \"{}\", {}, {}, {}, {} }}",
                     shapes[static_cast<std::size_t>(caster.shape)],
                     damages[static_cast<std::size_t>(caster.damage)], lua_of(caster.place),
                     lua_of(caster.axis), caster.degrees, lua_of(caster.scale));
}

}  // namespace shadowlab::measure
