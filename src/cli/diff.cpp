// shadowlab diff: how far two pictures are apart.
#include <fmt/format.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/files.h"
#include "core/error.h"
#include "image/difference.h"
#include "image/flip.h"
#include "image/heat_map.h"

namespace shadowlab::cli {
namespace {

struct DiffOptions {
  std::string a, b;
  std::string heat;
  std::string metric = "tolerance";
  double tolerance = 3;
};

// In steps of 8 bits, as --tolerance is: what the metric says of the two pictures.
struct Verdict {
  double distance;
  image::Image heat;
};

Verdict by_channels(const DiffOptions& options, const image::Image& a, const image::Image& b) {
  const bool by_rmse = options.metric == "rmse";
  const int steps = static_cast<int>(options.tolerance);
  const image::Difference difference = image::compare(a, b, steps);
  fmt::print(
      "differing  {} of {} pixels, {:.4f} %, by more than {}/255\n", difference.differing,
      difference.pixels,
      100.0 * static_cast<double>(difference.differing) / static_cast<double>(difference.pixels),
      steps);
  fmt::print("worst      {}/255\n", difference.worst);
  fmt::print("rmse       {:.6f}\n", difference.rmse);
  return {by_rmse ? 255 * difference.rmse : difference.worst,
          image::heat_map(a, b, by_rmse ? 0 : steps)};
}

Verdict by_flip(const image::Image& a, const image::Image& b) {
  const image::Flip flip = image::flip(a, b);
  fmt::print("flip mean  {:.6f}\n", flip.mean);
  fmt::print("flip worst {:.6f}\n", flip.worst);
  return {255 * flip.mean, image::heat_map(flip.error)};
}

Answer diff(const DiffOptions& options) {
  if (!(options.tolerance >= 0 && options.tolerance <= 255))
    throw InputError("--tolerance takes a number from 0 to 255, in steps of 8 bits");
  if (!options.heat.empty()) expect_writable(options.heat);
  const image::Image a = image::read_png(options.a), b = image::read_png(options.b);
  const Verdict verdict = options.metric == "flip" ? by_flip(a, b) : by_channels(options, a, b);
  if (!options.heat.empty()) write_picture(options.heat, verdict.heat);
  return verdict.distance > options.tolerance ? Answer::no : Answer::yes;
}

}  // namespace

void add_diff(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("diff", "Compare two pictures");
  auto options = std::make_shared<DiffOptions>();
  command->add_option("a", options->a, "The first picture")->required()->type_name("A.png");
  command->add_option("b", options->b, "The second, of the same size")
      ->required()
      ->type_name("B.png");
  command->add_option("-o,--output", options->heat, "A picture of where they differ")
      ->type_name("HEAT.png");
  command
      ->add_option("--metric", options->metric,
                   "tolerance: the worst channel of any pixel; rmse: over all channels; flip: the "
                   "mean of LDR-FLIP, what a person sees")
      ->check(one_of({"tolerance", "rmse", "flip"}))
      ->type_name("METRIC")
      ->capture_default_str();
  command
      ->add_option("--tolerance", options->tolerance,
                   "They differ where the metric is above this, in 1/255")
      ->type_name("N")
      ->capture_default_str();
  command->footer(
      "Example:\n  shadowlab diff mine.png reference.png -o where.png\n"
      "Ends with 0 where they are alike, 1 where they differ. Alpha is not compared.");
  command->callback([options, &answer] { answer = diff(*options); });
}

}  // namespace shadowlab::cli
