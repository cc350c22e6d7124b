#include "lab/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "core/error.h"
#include "recipe/recipe.h"
#include "truth/tracer.h"

namespace shadowlab::lab {
namespace {

// Neighbours whose colours differ by more than shading does between two pixels.
constexpr int color_step = 12;  // of 255

// The scene and the light of a case, where the recipe has both.
std::optional<std::pair<scene::Scene, scene::Light>> scene_of(gl::Graphics& graphics,
                                                              const Lab& lab, const Shot& shot) {
  recipe::Options options;
  options.scene = shot.scene;
  recipe::Recipe recipe(graphics, lab.solution(), options);
  for (const auto& [name, value] : shot.settings) recipe.set(name, value);
  if (shot.camera) recipe.set_camera(*shot.camera);
  const auto& known = recipe.parameters();
  const bool lit = std::any_of(known.begin(), known.end(), [](const auto& parameter) {
    return parameter.name == "light" && parameter.parameter.value.size() == 3;
  });
  if (!recipe.scene() || !lit) return std::nullopt;
  scene::Light light;
  light.position = recipe.light();
  return std::pair{*recipe.scene(), light};
}

PixelMask mask_of(const image::FloatImage& marks) {
  PixelMask mask(marks.values.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = marks.values[i] > 0.5f;
  return mask;
}

Regions traced(const scene::Scene& scene, const scene::Light& light, int width, int height) {
  const truth::Tracer tracer(scene);
  Regions regions;
  regions.edge = mask_of(tracer.edge_mask(scene.camera, light, width, height));
  const auto seen = tracer.visibility(scene.camera, light, width, height);
  const auto surfaces = tracer.surfaces(scene.camera, width, height);
  for (std::size_t i = 0; i < seen.values.size(); ++i) {
    regions.ground.push_back(!surfaces.surfaces[i].hit());
    regions.shadow.push_back(seen.values[i] < 0.5f);
  }
  return regions;
}

// Pixels with a neighbour of another colour.
Regions of_picture(const image::Image& picture) {
  Regions regions;
  const auto w = static_cast<std::size_t>(picture.width),
             h = static_cast<std::size_t>(picture.height);
  regions.edge.assign(w * h, 0);
  regions.shadow = regions.ground = regions.edge;
  const auto step = [&](std::size_t a, std::size_t b) {
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(int{picture.rgba[4 * a + c]} - picture.rgba[4 * b + c]));
    if (worst > color_step) regions.edge[a] = regions.edge[b] = 1;
  };
  for (std::size_t y = 0; y < h; ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t i = y * w + x;
      if (x + 1 < w) step(i, i + 1);
      if (y + 1 < h) step(i, i + w);
      if (x + 1 < w && y + 1 < h) step(i, i + w + 1);
      if (x > 0 && y + 1 < h) step(i, i + w - 1);
    }
  }
  return regions;
}

std::string bare(const std::string& name) {
  std::string letters;
  const auto first = std::find_if(name.begin(), name.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != ' ';
  });
  for (auto at = first; at != name.end(); ++at) {
    if (*at != ' ') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(*at)));
  }
  return letters;
}

void expect_pass(const Lab& lab, const Case& a_case, const Drawing& drawing,
                 const std::optional<std::string>& name) {
  if (!name || find_pass(drawing.passes, *name) >= 0) return;
  throw InputError(
      fmt::format("{}: the case \"{}\" compares after the pass \"{}\", which {} has not",
                  (lab.folder / "lab.lua").string(), a_case.name, *name, lab.solution().string()));
}

Job job_of(const Lab& lab, const std::filesystem::path& recipe) {
  Job job;
  job.recipe = recipe;
  job.width = lab.width;
  job.height = lab.height;
  job.passes = everything;
  job.calls = true;
  for (const Case& a_case : lab.cases) job.shots.push_back(a_case.shot);
  return job;
}

// A mistake's passes are only those that are compared: eight mistakes of four cases add up.
void forget_passes(Drawing& drawing, const Compared& compared) {
  std::vector<Buffers> kept;
  for (const auto& name : {compared.stencil, compared.depth}) {
    const int at = name ? find_pass(drawing.passes, *name) : -1;
    if (at >= 0) kept.push_back(drawing.passes[static_cast<std::size_t>(at)]);
  }
  drawing.passes = std::move(kept);
}

}  // namespace

int find_pass(const std::vector<Buffers>& passes, const std::string& name) {
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (passes[i].pass == name) return static_cast<int>(i);
  }
  const std::string sought = bare(name);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (bare(passes[i].pass) == sought) return static_cast<int>(i);
  }
  return -1;
}

const Regions& ReferenceCase::regions() const {
  std::call_once(traced_, [this] {
    const image::Image& picture = drawing_.frame.color;
    regions_ = scene_ ? traced(scene_->first, scene_->second, picture.width, picture.height)
                      : of_picture(picture);
  });
  return regions_;
}

Reference draw_reference(gl::Graphics& graphics, const Lab& lab) {
  Reference reference;
  reference.driver = graphics.context().renderer;
  draw(graphics, job_of(lab, lab.solution()), [&](std::size_t i, Drawing drawing) {
    const Case& a_case = lab.cases[i];
    if (drawing.error) {
      throw InputError(
          fmt::format("the solution fails in the case \"{}\": {}", a_case.name, *drawing.error));
    }
    expect_pass(lab, a_case, drawing, a_case.compared.stencil);
    expect_pass(lab, a_case, drawing, a_case.compared.depth);
    auto scene = scene_of(graphics, lab, a_case.shot);
    reference.cases.emplace_back(std::move(drawing), std::move(scene));
  });
  for (const Mistake& mistake : lab.mistakes) {
    auto& drawings = reference.mistakes.emplace_back();
    draw(graphics, job_of(lab, mistake.file), [&](std::size_t i, Drawing drawing) {
      forget_passes(drawing, lab.cases[i].compared);
      drawings.push_back(std::move(drawing));
    });
  }
  return reference;
}

}  // namespace shadowlab::lab
