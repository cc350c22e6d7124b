// shadowlab gallery: every recipe of scripts/ on one page.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "cli/captures.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/gallery_page.h"
#include "cli/progress.h"
#include "cli/session.h"
#include "core/clock.h"
#include "core/error.h"
#include "measure/median.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

struct GalleryOptions {
  std::string folder = "gallery";
  std::string size = "512x512";
  std::string context = "automatic";
};

constexpr int most_frames = 9;
constexpr double longest_timing = 1000;  // ms for one recipe

double median_frame(gl::Graphics& graphics, recipe::Recipe& recipe) {
  std::vector<double> times;
  const double end = now_ms() + longest_timing;
  do {
    graphics.gl.Finish.unrecorded();
    const double began = now_ms();
    recipe.draw();
    graphics.gl.Finish.unrecorded();
    times.push_back(now_ms() - began);
  } while (times.size() < most_frames && now_ms() < end);
  return measure::median(times);
}

std::vector<std::uint8_t> values_of(const std::vector<std::uint8_t>& stencil) {
  std::array<bool, 256> present{};
  for (const std::uint8_t value : stencil) present[value] = true;
  std::vector<std::uint8_t> values;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i]) values.push_back(static_cast<std::uint8_t>(i));
  }
  return values;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// One recipe's pictures, into `folder`; paths in the result are relative to it.
void draw(gl::Graphics& graphics, const fs::path& file, const fs::path& folder,
          ShownRecipe& shown) {
  recipe::Recipe recipe(graphics, file);
  shown.title = recipe.description().title;
  shown.lecture = recipe.description().lecture;
  shown.scene = recipe.description().scene;
  recipe.draw();  // the first frame compiles
  make_folder(folder / shown.name);
  recipe.on_pass_end([&](std::size_t index) {
    ShownPass pass{recipe.passes()[index].name, {}, {}, {}};
    const std::string stem = shown.name + "/" + stem_of(index, pass.name);
    pass.color = stem + ".color.png";
    pass.stencil = stem + ".stencil.png";
    const auto stencil = graphics.frame.read_stencil();
    pass.stencil_values = values_of(stencil);
    write_picture(folder / pass.color, graphics.frame.read_color());
    write_picture(folder / pass.stencil,
                  stencil_picture(stencil, graphics.width(), graphics.height()));
    shown.passes.push_back(std::move(pass));
  });
  recipe.draw();
  recipe.on_pass_end({});
  shown.picture = shown.name + ".png";
  write_picture(folder / shown.picture, graphics.frame.read_color());
  shown.milliseconds = median_frame(graphics, recipe);
}

Answer gallery(const GalleryOptions& options) {
  const auto [width, height] = parse_size(options.size);
  const auto files = all_recipes();
  if (files.empty()) throw InputError("scripts/ holds no recipe");
  const fs::path folder = options.folder;
  make_folder(folder);
  expect_writable(folder / "index.html");
  gl::Graphics graphics(context::create(context::backend_named(options.context)), width, height);
  Gallery gallery{{}, width, height, graphics.context().renderer};
  Answer answer = Answer::yes;
  ProgressLine progress;
  for (std::size_t i = 0; i < files.size(); ++i) {
    ShownRecipe shown;
    shown.name = files[i].stem().string();
    shown.title = shown.name;
    shown.source_file = fs::relative(files[i], folder).string();
    shown.source = text_of(files[i]);
    progress.show(i, files.size(), shown.name);
    try {
      draw(graphics, files[i].lexically_proximate(fs::current_path()), folder, shown);
    } catch (const std::runtime_error& problem) {  // the others are drawn all the same
      shown.error = problem.what();
      progress.clear();
      fmt::print(stderr, "shadowlab: {} is not drawn: {}\n", shown.name, shown.error);
      answer = Answer::no;
    }
    gallery.recipes.push_back(std::move(shown));
  }
  progress.clear();
  write_text(folder / "index.html", page_of(gallery));
  fmt::print("{} recipes: {}\n", gallery.recipes.size(), (folder / "index.html").string());
  return answer;
}

}  // namespace

void add_gallery(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("gallery", "Draw every recipe of scripts/ onto one page");
  auto options = std::make_shared<GalleryOptions>();
  command->add_option("-o,--output", options->folder, "The folder of index.html and its pictures")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--size", options->size, "Size of the pictures in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command
      ->add_option("--context", options->context, "osmesa, egl or glfw; else the first that works")
      ->type_name("CONTEXT");
  command->footer(
      "Example:\n  shadowlab gallery -o out/gallery\n"
      "Ends with 1 where a recipe could not be drawn; the page says why.");
  command->callback([options, &answer] { answer = gallery(*options); });
}

}  // namespace shadowlab::cli
