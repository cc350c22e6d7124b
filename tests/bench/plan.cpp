// planned against the same recipe without the plan (volumes_zfail): what modelling only what a
// frame needs saves, and what the planning costs where nothing can be saved.
//
//   bench_plan [SIZE] [FRAMES] [SCENE…]
//
// Each scene of the catalogue from its own camera and light. Milliseconds are medians of processor
// time over frames drawn in turns, on one thread; "ratio" that of the medians. Triangles and bytes
// are those of a frame. "plan" is the planning alone, a part of the planned frame. "differing" are
// pixels over the scene's own view and 20 seeded ones: none may.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "core/version.h"
#include "measure/check.h"
#include "measure/median.h"
#include "shadow/plan.h"

namespace shadowlab {
namespace {

constexpr int views = 21;

double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

class Side {
 public:
  Side(gl::Graphics& graphics, const std::string& name, const std::string& scene)
      : graphics_(graphics),
        recipe_(graphics, home() / "scripts" / (name + ".lua"), in_scene(scene)) {
    if (!this->scene() || this->scene()->lights.empty()) return;
    light_ = this->scene()->lights[0].position;
  }

  const scene::Scene* scene() const { return recipe_.scene(); }
  glm::dvec4 light() const { return light_; }
  const gl::Work& work() const { return recipe_.work(); }
  double milliseconds() const { return measure::median(times_); }

  image::Image look(const measure::View& view) {
    recipe_.set_camera(view.camera);
    recipe_.set_light(view.light);
    recipe_.draw();
    return graphics_.frame.read_color();
  }
  void draw() {
    graphics_.gl.Finish();
    const double begin = now();
    recipe_.draw();
    graphics_.gl.Finish();
    times_.push_back(now() - begin);
  }

 private:
  static recipe::Options in_scene(const std::string& scene) {
    recipe::Options options;
    options.scene = scene;
    return options;
  }

  gl::Graphics& graphics_;
  recipe::Recipe recipe_;
  glm::dvec4 light_{0};
  std::vector<double> times_;
};

std::size_t differing(const image::Image& a, const image::Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += !std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]);
  return count;
}

double planning(const scene::Scene& scene, glm::dvec4 light, int size, int frames) {
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) {
    const double begin = now();
    shadow::plan(scene, scene.camera, light, {size, size});
    times.push_back(now() - begin);
  }
  return measure::median(times);
}

void compare(gl::Graphics& graphics, const std::string& name, int frames) {
  Side without(graphics, "volumes_zfail", name), with(graphics, "planned", name);
  if (!without.scene() || without.scene()->lights.empty()) return;
  const scene::Scene own = *without.scene();
  std::size_t different = 0;
  for (int index = views; index-- > 0;) {
    const auto view = measure::view_of(own, without.light(), 1, index);
    const image::Image picture = without.look(view);
    different += differing(picture, with.look(view));
  }
  for (int frame = 0; frame < frames; ++frame) {
    without.draw();
    with.draw();
  }
  fmt::print(
      "{:<8} {:>8.3f} {:>8.3f} {:>6.2f} {:>7.3f} {:>9} {:>9} {:>9} {:>9} {:>10}\n", name,
      without.milliseconds(), with.milliseconds(), without.milliseconds() / with.milliseconds(),
      planning(own, without.light(), graphics.width(), frames), without.work().triangles,
      with.work().triangles, without.work().upload_bytes, with.work().upload_bytes, different);
  std::fflush(stdout);
}

}  // namespace
}  // namespace shadowlab

int main(int argc, char** argv) {
  using namespace shadowlab;
  setenv("LP_NUM_THREADS", "0", 1);
  const int size = argc > 1 ? std::atoi(argv[1]) : 512, frames = argc > 2 ? std::atoi(argv[2]) : 31;
  gl::Graphics graphics(context::create(), size, size);
  std::vector<std::string> scenes(argv + std::min(argc, 3), argv + argc);
  if (scenes.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts" / "scenes"))
      scenes.push_back(entry.path().stem().string());
    std::sort(scenes.begin(), scenes.end());
  }
  fmt::print("{:<8} {:>8} {:>8} {:>6} {:>7} {:>9} {:>9} {:>9} {:>9} {:>10}\n", "scene", "ms",
             "planned", "ratio", "plan", "triangles", "planned", "bytes", "planned", "differing");
  for (const std::string& scene : scenes) compare(graphics, scene, frames);
}
