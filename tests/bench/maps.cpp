// What shadow maps are worth: wrong pixels. bench_map_costs prints what they cost.
//
//   bench_maps [--quick] [sizes] [scenes] [cascades]
//
// sizes     wrong pixels of each map recipe against the exact truth, maps of 256 to 4096 texels a
//           side, over several scenes; the exponent is the slope of the line through the
//           logarithms: -1 where what is wrong is a strip along the shadows' edges, a texel wide
// scenes    the same for each scene of the catalogue, one view of 128 x 128; the map without
//           aliasing, which has no size, beside them
// cascades  four maps against one of as many texels: wrong pixels among the nearer and the farther
//           half of what the camera sees
//
// sizes and cascades where none is named. --quick: a smaller frame, fewer sizes, scenes and views.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/version.h"
#include "measure/check.h"
#include "measure/median.h"
#include "truth/tracer.h"

namespace shadowlab {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::filesystem::path file_of(const std::string& recipe) {
  return home() / "scripts" / (recipe + ".lua");
}

// Of the least squares line through (log x, log y), where y is not 0; NaN for fewer than two
// points.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (y[i] <= 0) continue;
    const double u = std::log(x[i]), v = std::log(y[i]);
    n += 1, sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// ---- wrong pixels against the map's size

struct MapRecipe {
  std::string name;
  Settings settings;
};

// A filter blurs over texels, whose width is part of what is wrong: so it is held to the least one.
const std::vector<MapRecipe>& map_recipes() {
  static const std::vector<MapRecipe> recipes{
      {"shadow_map_copy", {}},
      {"shadow_map_fbo", {}},
      {"shadow_map_sampler", {}},
      {"shadow_map_problems", {}},
      {"shadow_map_pcf", {}},
      {"shadow_map_cube", {}},
      {"shadow_map_cascades", {}},
      {"shadow_map_stable", {}},
      {"shadow_map_moments", {{"kind", "variance"}, {"reach", "1"}}},
      {"shadow_map_moments", {{"kind", "four"}, {"reach", "1"}}},
  };
  return recipes;
}

std::string title_of(const MapRecipe& recipe) {
  std::string title = recipe.name.substr(std::string("shadow_map_").size());
  if (!recipe.settings.empty()) title += " " + recipe.settings[0].second;
  return title;
}

void print_row(const std::string& recipe, const std::string& scene, int views,
               const std::vector<double>& sizes, const std::vector<double>& wrong) {
  fmt::print("{:<18} {:<8} {:>5}", recipe, scene, views);
  for (const double count : wrong) fmt::print(" {:>7}", count);
  const double slope = exponent(sizes, wrong);
  fmt::print(" {:>8}\n", std::isfinite(slope) ? fmt::format("{:.2f}", slope) : "-");
  std::fflush(stdout);
}

struct Extent {
  int side, views;  // of the pictures, and how many in each scene
  std::vector<double> sizes;
  std::vector<std::string> scenes;
};

std::vector<std::string> catalogue() {
  std::vector<std::string> scenes;
  for (const auto& file : std::filesystem::directory_iterator(home() / "scripts" / "scenes"))
    scenes.push_back(file.path().stem().string());
  std::ranges::sort(scenes);
  return scenes;
}

void exact_row(gl::Graphics& graphics, const Extent& extent) {
  std::size_t wrong = 0;
  int views = 0;
  for (const std::string& scene : extent.scenes) {
    measure::CheckOptions options;
    options.scene = scene;
    options.views = extent.views;
    options.per_pixel = 1;
    const auto result = measure::check(graphics, file_of("shadow_map_exact"), options);
    views += result.views, wrong += result.wrong;
  }
  fmt::print("{:<18} {:<8} {:>5} {:>7}, whatever its cells\n", "exact", "all", views, wrong);
}

void sizes_table(const Extent& extent) {
  const auto& [side, views_each, sizes, scenes] = extent;
  gl::Graphics graphics(context::create(), side, side);
  fmt::print("Wrong pixels of {0} x {0}, views summed, against the side of the map\n", side);
  fmt::print("{:<18} {:<8} {:>5}", "recipe", "scene", "views");
  for (const double size : sizes) fmt::print(" {:>7}", size);
  fmt::print(" {:>8}\n", "exponent");
  for (const MapRecipe& recipe : map_recipes()) {
    std::vector<double> all(sizes.size());
    int views = 0;
    for (const std::string& scene : scenes) {
      std::vector<double> wrong(sizes.size());
      measure::CheckResult result;
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        measure::CheckOptions options;
        options.scene = scene;
        options.settings = recipe.settings;
        options.settings.emplace_back("size", fmt::format("{}", sizes[i]));
        options.views = views_each;
        options.per_pixel = 1;  // what is wrong at an edge counts here as any other
        result = measure::check(graphics, file_of(recipe.name), options);
        wrong[i] = static_cast<double>(result.wrong);
        all[i] += wrong[i];
      }
      if (result.views == 0) continue;  // the recipe says that it does not hold there
      views += result.views;
      print_row(title_of(recipe), scene, result.views, sizes, wrong);
    }
    print_row(title_of(recipe), "all", views, sizes, all);
  }
  exact_row(graphics, extent);
  fmt::print("\n");
}

// ---- cascades against one map of as many texels

struct NearAndFar {
  double near = 0, far = 0;
};

// One view, its truth, and the depth that as many of its pixels are before as behind.
class SeenView {
 public:
  SeenView(const scene::Scene& scene, const measure::View& view, int size) : view_(view) {
    const truth::Tracer tracer(scene);
    scene::Light light;
    light.position = view.light;
    truth_ = tracer.visibility(view.camera, light, size, size);
    surfaces_ = tracer.surfaces(view.camera, size, size);
    std::vector<double> depths;
    for (const auto& surface : surfaces_.surfaces) {
      if (surface.hit()) depths.push_back(surface.depth);
    }
    middle_ = depths.empty() ? 0 : measure::median(depths);
  }

  NearAndFar wrong(gl::Graphics& graphics, recipe::Recipe& recipe) const {
    recipe.set_camera(view_.camera);
    recipe.set_light(view_.light);
    recipe.draw();
    const image::Image picture = graphics.frame.read_color();
    NearAndFar wrong;
    for (std::size_t i = 0; i < surfaces_.surfaces.size(); ++i) {
      const auto& surface = surfaces_.surfaces[i];
      if (!surface.hit()) continue;
      const bool lit = picture.rgba[4 * i] > 127, is = truth_.values[i] > 0.5f;
      if (lit != is) (surface.depth < middle_ ? wrong.near : wrong.far) += 1;
    }
    return wrong;
  }

 private:
  measure::View view_;
  image::FloatImage truth_;
  truth::SurfaceImage surfaces_;
  double middle_ = 0;
};

recipe::Options drawing_visibility(const std::string& scene) {
  recipe::Options options;
  options.scene = scene;
  options.shading = recipe::Options::Shading::visibility;
  return options;
}

// The city's own view, and from street level along the streets.
std::vector<measure::View> views_of_city(const scene::Scene& scene, bool quick) {
  std::vector<measure::View> views{{scene.camera, glm::dvec4(0.7, 0.75, 0.3, 0)}};
  for (int i = 1; i < (quick ? 2 : 4); ++i) {
    measure::View view = views[0];
    view.camera.eye += glm::dvec3(7.0 * i, 0, -11.0 * i);
    view.camera.target += glm::dvec3(-9.0 * i, 0, -11.0 * i);
    views.push_back(view);
  }
  return views;
}

void cascades_table(bool quick) {
  const int side = quick ? 128 : 384;
  gl::Graphics graphics(context::create(), side, side);
  const std::string name = "shadow_map_cascades";
  const scene::Scene scene =
      *recipe::Recipe(graphics, file_of(name), drawing_visibility("city")).scene();
  std::vector<SeenView> views;
  for (const auto& view : views_of_city(scene, quick)) views.emplace_back(scene, view, side);
  fmt::print(
      "Four maps against one of as many texels: wrong pixels of {0} x {0} in city, {1} views, the\n"
      "nearer and the farther half of what is seen; the ratio is one map's count over the four's\n",
      side, views.size());
  fmt::print("{:<8} {:>9} {:>9} {:>8} {:>8} {:>7} {:>8} {:>8} {:>7}\n", "by", "one", "four",
             "near 1", "near 4", "ratio", "far 1", "far 4", "ratio");
  for (const std::string by : {"view", "camera", "groups"}) {
    for (const int size : {256, 512, 1024}) {
      const auto sum = [&](const std::string& count, int of_size) {
        recipe::Recipe recipe(graphics, file_of(name), drawing_visibility("city"));
        recipe.set("by", count == "1" ? "view" : by);
        recipe.set("count", count);
        recipe.set("size", std::to_string(of_size));
        NearAndFar all;
        for (const SeenView& view : views) {
          const NearAndFar wrong = view.wrong(graphics, recipe);
          all.near += wrong.near, all.far += wrong.far;
        }
        return all;
      };
      const NearAndFar one = sum("1", 2 * size), four = sum("4", size);
      fmt::print("{:<8} {:>9} {:>9} {:>8} {:>8} {:>7.2f} {:>8} {:>8} {:>7.2f}\n", by,
                 fmt::format("{}^2", 2 * size), fmt::format("4 x {}^2", size), one.near, four.near,
                 one.near / four.near, one.far, four.far, one.far / four.far);
      std::fflush(stdout);
      if (quick) break;
    }
  }
  fmt::print("\n");
}

}  // namespace
}  // namespace shadowlab

int main(int count, char** arguments) {
  using namespace shadowlab;
  std::set<std::string> words(arguments + 1, arguments + count);
  const bool quick = words.erase("--quick") > 0;
  const auto wanted = [&](const char* part) { return words.empty() || words.contains(part); };
  const std::vector<double> sizes{256, 512, 1024, 2048, 4096};
  if (wanted("sizes") && quick) sizes_table({128, 1, {256, 1024, 4096}, {"table", "city"}});
  if (wanted("sizes") && !quick)
    sizes_table({256, 3, sizes, {"table", "tetra", "cornell", "comb", "city"}});
  if (words.contains("scenes")) sizes_table({128, 1, sizes, catalogue()});
  if (wanted("cascades")) cascades_table(quick);
}
