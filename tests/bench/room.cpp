// The lab's room: the lecture's way (room), which redraws all for each place of the light and
// averages by glAccum, against the fast one (room_fast), which sums visibility alone and shades
// once.
//
//   bench_room [SIZE]
//   bench_room adaptive [VIEWS]
//
// 1. The same 16 points: milliseconds a frame, medians of frames drawn in turns, their ratio, and
//    the RMSE between the two pictures in steps of 1/255.
// 2. Equal time: the error against rays to all of the light, of the lecture's way with 16 random
//    points (over 8 seeds), and of the fast way with the default pattern and as many points as it
//    draws in that time. Errors are those of 128 by 128 pixels, times of SIZE.
// 3. Adaptive: over seeded views at 128 by 128, points that grow until the error asked for is
//    estimated; how many views meet it, how many points they took, and how many points, the same
//    for all views, meet it in as many (the room's and the lamp's views of measure/check.h, where a
//    light has a place).
// LP_NUM_THREADS decides how many threads llvmpipe has (0: none beside the caller's); times are
// wall time, so run it alone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/version.h"
#include "measure/check.h"
#include "measure/median.h"
#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab {
namespace {

using Shading = recipe::Options::Shading;

class Way {
 public:
  Way(gl::Graphics& graphics, const std::string& name, Shading shading = Shading::full)
      : graphics_(graphics),
        recipe_(graphics, home() / "scripts" / (name + ".lua"), with(shading)) {}

  recipe::Recipe& recipe() { return recipe_; }
  image::Image look() {
    recipe_.draw();
    return graphics_.frame.read_color();
  }
  void time() {
    graphics_.gl.Finish();
    const auto begin = std::chrono::steady_clock::now();
    recipe_.draw();
    graphics_.gl.Finish();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - begin;
    times_.push_back(spent.count());
  }
  double milliseconds() const { return measure::median(times_); }
  void forget() { times_.clear(); }

 private:
  static recipe::Options with(Shading shading) {
    recipe::Options options;
    options.limits.seconds = 3600;
    options.shading = shading;
    return options;
  }
  gl::Graphics& graphics_;
  recipe::Recipe recipe_;
  std::vector<double> times_;
};

double rmse_between(const image::Image& a, const image::Image& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 != 3) squares += std::pow(double(a.rgba[i]) - double(b.rgba[i]), 2);
  }
  return std::sqrt(squares / (0.75 * double(a.rgba.size())));
}

// What rays to all of the light see of the walls.
class Truth {
 public:
  /// `error` is the standard error of a pixel.
  Truth(const scene::Scene& scene, glm::dvec4 position, double radius, int size, double error) {
    scene::Light light;
    light.position = position;
    light.shape = scene::Light::Shape::sphere;
    light.radius = radius;
    const truth::Tracer tracer(scene);
    truth::Sampling sampling;
    sampling.samples = 16384;
    sampling.seed = 1234;
    sampling.error = error;
    visibility_ = tracer.visibility(scene.camera, light, size, size, sampling);
    for (const auto& surface : tracer.surfaces(scene.camera, size, size).surfaces)
      wall_.push_back(surface.hit() && !scene.objects[surface.object].casts());
  }
  /// Over the walls' pixels.
  double rmse(const image::Image& picture) const {
    return std::sqrt(squares(picture) / double(std::count(wall_.begin(), wall_.end(), true)));
  }
  /// Over the picture's, of which the others have no error.
  double rmse_over_all(const image::Image& picture) const {
    return std::sqrt(squares(picture) / double(wall_.size()));
  }

 private:
  double squares(const image::Image& picture) const {
    double sum = 0;
    for (std::size_t i = 0; i < wall_.size(); ++i) {
      if (wall_[i]) sum += std::pow(picture.rgba[4 * i] / 255.0 - double(visibility_.values[i]), 2);
    }
    return sum;
  }
  image::FloatImage visibility_;
  std::vector<bool> wall_;
};

double time_of(Way& way, const std::string& jitters, int frames) {
  way.recipe().set("jitters", jitters);
  way.recipe().draw();
  way.forget();
  for (int i = 0; i < frames; ++i) way.time();
  return way.milliseconds();
}

void run(int size) {
  gl::Graphics graphics(context::create(), size, size);
  Way lecture(graphics, "room"), fast(graphics, "room_fast");
  const double between = rmse_between(lecture.look(), fast.look());
  for (int i = 0; i < 15; ++i) {
    lecture.time();
    fast.time();
  }
  const double given = lecture.milliseconds(), ms = fast.milliseconds();
  const char* threads = std::getenv("LP_NUM_THREADS");
  fmt::print("LP_NUM_THREADS {}, {} by {} pixels\n", threads ? threads : "unset", size, size);
  fmt::print("16 points     room {:7.2f} ms, room_fast {:6.2f} ms, ratio {:.2f}, RMSE {:.2f}/255\n",
             given, ms, given / ms, between);
  std::fflush(stdout);

  const double many = time_of(fast, "256", 3);
  const double each = (many - ms) / 240;
  const int points = std::max(16, static_cast<int>((given - ms) / each) + 16);
  const double spent = time_of(fast, std::to_string(points), 5);
  std::fflush(stdout);
  gl::Graphics small(context::create(), 128, 128);
  small.context().make_current();
  Way random(small, "room", Shading::visibility), best(small, "room_fast", Shading::visibility);
  random.recipe().set("pattern", "random");
  random.recipe().set("storage", "float32");
  best.recipe().set("jitters", std::to_string(points));
  const Truth truth(*best.recipe().scene(), best.recipe().light(), 0.12, small.width(), 0.001);
  double squares = 0;
  for (int seed = 1; seed <= 8; ++seed) {
    random.recipe().set("seed", std::to_string(seed));
    squares += std::pow(truth.rmse(random.look()), 2);
  }
  const double lectures = std::sqrt(squares / 8), ours = truth.rmse(best.look());
  fmt::print("equal time    room, 16 random points: error {:.5f} in {:.1f} ms\n", lectures, given);
  fmt::print("              room_fast, {} points: error {:.5f} in {:.1f} ms\n", points, ours,
             spent);
  fmt::print("              error ratio {:.1f}\n", lectures / ours);
}

// How many points the last frame took: its last estimate's pass says so.
int points_of(const recipe::Recipe& recipe) {
  int points = 0;
  for (const auto& pass : recipe.passes())
    std::sscanf(pass.name.c_str(), "what %d points", &points);
  return points;
}

constexpr std::array fixed_counts{16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024};

struct AdaptiveRow {
  int views = 0, met = 0;
  double points = 0;
  std::array<int, fixed_counts.size()> met_by_fixed{};
};

AdaptiveRow adaptive(gl::Graphics& graphics, double asked, int views) {
  Way way(graphics, "room_fast", Shading::visibility);
  recipe::Recipe& recipe = way.recipe();
  recipe.set("pattern", "owen");
  scene::Scene scene = *recipe.scene();
  const glm::dvec4 own = recipe.light();
  AdaptiveRow row;
  for (int index = 0; row.views < views; ++index) {
    const auto view = measure::view_of(scene, own, 1, index);
    recipe.set_camera(view.camera);
    recipe.set_light(view.light);
    if (!recipe.holds()) continue;
    scene::Scene seen = scene;
    seen.camera = view.camera;
    const Truth truth(seen, view.light, 0.12, graphics.width(), asked / 2);
    ++row.views;
    recipe.set("error", fmt::format("{}", asked));
    row.met += truth.rmse_over_all(way.look()) <= asked ? 1 : 0;
    row.points += points_of(recipe);
    recipe.set("error", "0");
    // What more points do is not asked once a number of them is enough.
    bool met = false;
    for (std::size_t n = 0; n < fixed_counts.size(); ++n) {
      recipe.set("jitters", std::to_string(fixed_counts[n]));
      met = met || truth.rmse_over_all(way.look()) <= asked;
      row.met_by_fixed[n] += met ? 1 : 0;
    }
  }
  return row;
}

void run_adaptive(int views) {
  gl::Graphics graphics(context::create(), 128, 128);
  fmt::print("{:>7} {:>6} {:>6} {:>14} {:>22} {:>6}\n", "asked", "views", "met", "points a view",
             "fixed that meets as many", "ratio");
  for (const double asked : {0.01, 0.005, 0.0025}) {
    const AdaptiveRow row = adaptive(graphics, asked, views);
    const double points = row.points / row.views;
    std::size_t n = 0;
    while (n + 1 < fixed_counts.size() && row.met_by_fixed[n] < row.met) ++n;
    fmt::print("{:>7} {:>6} {:>5.1f}% {:>14.1f} {:>22} {:>6.2f}\n", asked, row.views,
               100.0 * row.met / row.views, points, fixed_counts[n], fixed_counts[n] / points);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace shadowlab

int main(int count, char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "512";
  if (first == "adaptive") {
    shadowlab::run_adaptive(count > 2 ? std::atoi(arguments[2]) : 40);
  } else {
    shadowlab::run(std::atoi(first.c_str()));
  }
}
