// bench_plan [SIZE] [FRAMES] [SCENE...]: what a plan saves, and what it costs.
//
// Tables: of each scene `planned` against volumes_zfail, and against its own passes without a plan;
// of recipes that know of none with and without run --plan: milliseconds of processor time of a
// frame, of planning alone, pixels rasterised (counted by a query, before tests), triangles and
// bytes given to GL, bytes that its textures hold, and how many pixels differ over the scene's own
// view and 20 seeded ones: none may. Frames are drawn in turns; medians; the driver draws in our
// thread, so that its time counts and a busy machine's does not.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "core/version.h"
#include "gl/held.h"
#include "measure/check.h"
#include "measure/fill.h"
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

// A recipe in a scene, and how it is told to draw.
struct Run {
  std::string recipe, scene;
  recipe::Options::Casters casters = recipe::Options::Casters::all;
  std::string set, value;
};

class Side {
 public:
  Side(gl::Graphics& graphics, const Run& run)
      : graphics_(graphics),
        recipe_(graphics, home() / "scripts" / (run.recipe + ".lua"), options_of(run)) {
    if (!run.set.empty()) recipe_.set(run.set, run.value);
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
    if (!recipe_.holds()) return {};
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
  // Millions of pixels, of 1000 · 1000.
  double megapixels() {
    double all = 0;
    for (const auto& pass : measure::fill_of(graphics_, recipe_, 0)) all += pass.covered();
    return all * 1.048576;
  }

 private:
  static recipe::Options options_of(const Run& run) {
    recipe::Options options;
    options.scene = run.scene;
    options.casters = run.casters;
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

void print_head(const char* what) {
  fmt::print("{:<20} {:>15} {:>5} {:>6} {:>13} {:>13} {:>15} {:>13} {:>9}\n", what, "ms", "ratio",
             "plan", "Mpix", "triangles", "bytes sent", "KiB held", "differing");
}

// KiB of textures that drawing the run for the first time makes GL hold, the picture's aside.
std::uint64_t held_by(int size, const Run& run) {
  gl::Graphics graphics(context::create(), size, size);
  const std::uint64_t before = gl::held(graphics.gl).textures.bytes;
  Side side(graphics, run);
  side.draw();
  return (gl::held(graphics.gl).textures.bytes - before) / 1024;
}

void compare(gl::Graphics& graphics, const std::string& name, const Run& without_plan,
             const Run& with_plan, int frames) {
  Side without(graphics, without_plan), with(graphics, with_plan);
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
  const auto pair = [](auto a, auto b, const char* form) {
    return fmt::format(fmt::runtime(form), a, b);
  };
  const gl::Work &all = without.work(), &some = with.work();
  const int size = graphics.width();
  const std::string times = pair(without.milliseconds(), with.milliseconds(), "{:.2f} {:.2f}");
  const std::string triangles = pair(all.triangles, some.triangles, "{} {}"),
                    bytes = pair(all.upload_bytes, some.upload_bytes, "{} {}"),
                    held = pair(held_by(size, without_plan), held_by(size, with_plan), "{} {}");
  fmt::print("{:<20} {:>15} {:>5.2f} {:>6.3f} {:>13} {:>13} {:>15} {:>13} {:>9}\n", name, times,
             without.milliseconds() / with.milliseconds(),
             planning(own, without.light(), size, frames),
             pair(without.megapixels(), with.megapixels(), "{:.2f} {:.2f}"), triangles, bytes, held,
             different);
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
  using Casters = recipe::Options::Casters;
  print_head("planned : zfail");
  for (const std::string& scene : scenes) {
    compare(graphics, scene, {"volumes_zfail", scene, Casters::all, "", ""},
            {"planned", scene, Casters::all, "", ""}, frames);
  }
  print_head("planned : plan=false");
  for (const std::string& scene : scenes) {
    compare(graphics, scene, {"planned", scene, Casters::all, "plan", "false"},
            {"planned", scene, Casters::all, "plan", "true"}, frames);
  }
  print_head("run --plan, in city");
  for (const char* name : {"volumes_zfail", "volumes_auto", "volumes_gpu", "shadow_map_fbo",
                           "shadow_map_pcf", "shadow_map_cascades", "shadow_map_stable"}) {
    compare(graphics, name, {name, "city", Casters::all, "", ""},
            {name, "city", Casters::planned, "", ""}, frames);
  }
  const Run cube{"shadow_map_cube", "room", Casters::all, "keep", "false"};
  Run planned_cube = cube;
  planned_cube.casters = Casters::planned;
  print_head("run --plan, in room");
  compare(graphics, "shadow_map_cube", cube, planned_cube, frames);
}
