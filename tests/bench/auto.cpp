// volumes_auto against volumes_zfail over all scenes: what choosing z-pass where it is right saves.
//
//   bench_auto [SIZE]
//
// Each scene from its own camera and light and from four seeded ones; sums over the five. Pixels
// are those that the stencil passes rasterise, triangles those of whole frames, milliseconds
// medians of frames drawn in turns. "differing" counts the pixels where the two pictures differ:
// none may.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/clock.h"
#include "core/version.h"
#include "measure/check.h"
#include "measure/fill.h"
#include "measure/median.h"

namespace shadowlab {
namespace {

constexpr int views = 5, frames = 11;

recipe::Options in_scene(const std::string& scene) {
  recipe::Options options;
  options.scene = scene;
  return options;
}

struct Cost {
  double mpix = 0, ms = 0;
  std::uint64_t triangles = 0;
};

class Side {
 public:
  Side(gl::Graphics& graphics, const std::string& name, const std::string& scene)
      : graphics_(graphics),
        recipe_(graphics, home() / "scripts" / (name + ".lua"), in_scene(scene)) {}

  recipe::Recipe& recipe() { return recipe_; }
  const Cost& cost() const { return cost_; }

  void look(const measure::View& view) {
    recipe_.set_camera(view.camera);
    recipe_.set_light(view.light);
    for (const auto& pass : measure::fill_of(graphics_, recipe_, 0)) {
      cost_.mpix += pass.mpix[static_cast<std::size_t>(measure::Layer::stencil)];
      cost_.triangles += pass.triangles;
    }
    times_.clear();
    recipe_.draw();
    picture_ = graphics_.frame.read_color();
  }
  void draw() {
    graphics_.gl.Finish();
    const double begin = now_ms();
    recipe_.draw();
    graphics_.gl.Finish();
    times_.push_back(now_ms() - begin);
  }
  void end_view() { cost_.ms += measure::median(times_); }
  const image::Image& picture() const { return picture_; }

 private:
  gl::Graphics& graphics_;
  recipe::Recipe recipe_;
  Cost cost_;
  std::vector<double> times_;
  image::Image picture_;
};

std::size_t differing(const image::Image& a, const image::Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += !std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                         a.rgba.begin() + static_cast<std::ptrdiff_t>(i + 4),
                         b.rgba.begin() + static_cast<std::ptrdiff_t>(i));
  return count;
}

void compare(gl::Graphics& graphics, const std::string& scene) {
  Side zfail(graphics, "volumes_zfail", scene), automatic(graphics, "volumes_auto", scene);
  if (!zfail.recipe().scene() || zfail.recipe().scene()->lights.empty()) return;
  const scene::Scene& own = *zfail.recipe().scene();
  std::size_t different = 0;
  for (int index = 0; index < views; ++index) {
    const measure::View view = measure::view_of(own, own.lights[0].position, 1, index);
    zfail.look(view);
    automatic.look(view);
    different += differing(zfail.picture(), automatic.picture());
    for (int frame = 0; frame < frames; ++frame) {
      zfail.draw();
      automatic.draw();
    }
    zfail.end_view();
    automatic.end_view();
  }
  const Cost &z = zfail.cost(), &a = automatic.cost();
  fmt::print(
      "{:<10} {:>9.3f} {:>9.3f} {:>5.0f}% {:>10} {:>10} {:>5.0f}% {:>8.2f} {:>8.2f} {:>7.2f} "
      "{:>10}\n",
      scene, z.mpix, a.mpix, 100 * (1 - a.mpix / z.mpix), z.triangles, a.triangles,
      100 * (1 - double(a.triangles) / double(z.triangles)), z.ms, a.ms, z.ms - a.ms, different);
  std::fflush(stdout);
}

}  // namespace
}  // namespace shadowlab

int main(int argc, char** argv) {
  using namespace shadowlab;
  const int size = argc > 1 ? std::atoi(argv[1]) : 512;
  gl::Graphics graphics(context::create(), size, size);
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts" / "scenes"))
    scenes.push_back(entry.path().stem().string());
  std::sort(scenes.begin(), scenes.end());
  fmt::print("{:<10} {:>9} {:>9} {:>6} {:>10} {:>10} {:>6} {:>8} {:>8} {:>7} {:>10}\n", "scene",
             "Mpix", "auto", "saved", "triangles", "auto", "saved", "ms", "auto", "saved",
             "differing");
  for (const std::string& scene : scenes) compare(graphics, scene);
}
