// Shadow volumes built on the CPU against those that a vertex or a geometry shader makes, under a
// light that moves every frame.
//
//   LP_NUM_THREADS=0 bench_extrusion [SIZE]
//
// Milliseconds of processor time, which others on the machine do not lengthen: medians of 21 whole
// frames drawn in turns, up to glFinish; with LP_NUM_THREADS=0 Mesa's software rasteriser has no
// threads of its own to leave out. Mtri/s are the casters' triangles over that time. Small pictures
// show what vertices cost, large ones what filling adds. In software the shaders run on the CPU
// too, and geometry shaders leave the fast path.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "core/version.h"
#include "recipe/recipe.h"

namespace shadowlab {
namespace {

constexpr int frames = 21;

class Technique {
 public:
  Technique(gl::Graphics& graphics, const std::string& name, const std::string& scene,
            const std::string& extruder)
      : recipe_(graphics, home() / "scripts" / (name + ".lua"), in_scene(scene)) {
    if (!extruder.empty()) recipe_.set("extruder", extruder);
  }

  const recipe::Recipe& recipe() const { return recipe_; }

  void draw(gl::Graphics& graphics, glm::dvec4 light) {
    recipe_.set_light(light);
    graphics.gl.Finish();
    const std::clock_t begin = std::clock();
    recipe_.draw();
    graphics.gl.Finish();
    times_.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  void forget() { times_.clear(); }
  double median() {
    const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
    std::nth_element(times_.begin(), middle, times_.end());
    return *middle;
  }

 private:
  static recipe::Options in_scene(const std::string& scene) {
    recipe::Options options;
    options.scene = scene;
    return options;
  }
  recipe::Recipe recipe_;
  std::vector<double> times_;
};

void compare(gl::Graphics& graphics, const std::string& scene) {
  Technique built(graphics, "volumes_zfail", scene, ""),
      vertex(graphics, "volumes_gpu", scene, "vertex"),
      geometry(graphics, "volumes_gpu", scene, "geometry");
  const scene::Scene& world = *built.recipe().scene();
  std::size_t triangles = 0;
  for (const auto& object : world.objects) {
    if (object.casts()) triangles += object.mesh->triangle_count();
  }
  const glm::dvec4 light = world.lights[0].position;
  const auto all = {&built, &vertex, &geometry};
  for (int frame = -2; frame < frames; ++frame) {
    // The first two compile shaders and build what stays.
    if (frame == 0) {
      for (Technique* technique : all) technique->forget();
    }
    const glm::dvec4 moved = light + glm::dvec4(0.01 * std::sin(frame), 0, 0.01 * frame, 0);
    for (Technique* technique : all) technique->draw(graphics, moved);
  }
  fmt::print("{:<8} {:>9}", scene, triangles);
  for (Technique* technique : all) {
    const double ms = technique->median();
    fmt::print(" {:>9.3f} {:>7.2f}", ms, static_cast<double>(triangles) / ms / 1e3);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace shadowlab

int main(int argc, char** argv) {
  using namespace shadowlab;
  const int size = argc > 1 ? std::atoi(argv[1]) : 512;
  gl::Graphics graphics(context::create(), size, size);
  fmt::print("{:<8} {:>9} {:>9} {:>7} {:>9} {:>7} {:>9} {:>7}\n", "scene", "triangles", "built ms",
             "Mtri/s", "vertex ms", "Mtri/s", "geom. ms", "Mtri/s");
  for (const char* scene : {"tetra", "mobius", "comb", "room", "table", "grass"})
    compare(graphics, scene);
}
