#include "measure/measurement.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>

#include "core/clock.h"
#include "core/error.h"
#include "gl/held.h"
#include "image/flip.h"
#include "image/heat_map.h"

namespace shadowlab::measure {
namespace {

using Shading = recipe::Options::Shading;

constexpr std::size_t most_passes = 12;  // that are told apart by the numbers in their names

// Without numbers: "the hard shadow of point # of #".
std::string without_numbers(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit) text += c;
    if (digit && !text.ends_with('#')) text += '#';
  }
  return text;
}

// Which row of a table each pass belongs to, and the rows' names.
struct Rows {
  std::vector<std::size_t> row_of_pass;
  std::vector<std::string> names;
};

template <class Passes>
Rows rows_of(const Passes& passes) {
  Rows rows;
  const bool many = passes.size() > most_passes;
  for (const auto& pass : passes) {
    const std::string name = many ? without_numbers(pass.name) : pass.name;
    const auto found = std::find(rows.names.begin(), rows.names.end(), name);
    rows.row_of_pass.push_back(static_cast<std::size_t>(found - rows.names.begin()));
    if (found == rows.names.end()) rows.names.push_back(name);
  }
  return rows;
}

std::vector<PassFill> summed(const std::vector<PassFill>& passes) {
  const Rows rows = rows_of(passes);
  std::vector<PassFill> sums(rows.names.size());
  for (PassFill& sum : sums) sum.count = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    PassFill& sum = sums[rows.row_of_pass[i]];
    sum.name = rows.names[rows.row_of_pass[i]];
    for (std::size_t kind = 0; kind < layer_count; ++kind) sum.mpix[kind] += passes[i].mpix[kind];
    sum.triangles += passes[i].triangles;
    ++sum.count;
  }
  return sums;
}

// The process's peak resident memory can be set back to what it has now (proc(5), clear_refs).
void forget_peak() {
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

std::uint64_t peak() {
  std::ifstream status("/proc/self/status");
  std::string word;
  std::uint64_t kibibytes = 0;
  while (status >> word) {
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

std::uint64_t held_bytes(const gl::Graphics& graphics) {
  const gl::Held held = gl::held(graphics.gl);
  return held.buffers.bytes + held.textures.bytes + held.renderbuffers.bytes;
}

// What the technique says of each pixel, held against the truth. Sets left_out where it says
// nothing.
void draw_visibility(gl::Graphics& graphics, const Job& job, GroundTruth& truth, double radius,
                     Look& look, LookPictures& pictures) {
  const auto recipe = recipe_of(graphics, job, radius, Shading::visibility);
  look.title = recipe->description().title;
  const Claim claim = claim_of(*recipe, job.recipe);
  look.soft = claim.soft();
  look.on_receivers = claim.on_receivers;
  if (look.soft && truth.light().w == 0) {
    look.left_out = "the light is at infinity, where it has no size";
  } else if (!recipe->holds()) {
    look.left_out = "the recipe says that its technique does not hold for this camera and light";
  }
  if (look.left_out) return;
  const TracedTruth& traced = truth.of(claim.radius);
  recipe->draw();
  pictures.visibility = graphics.frame.read_color();
  const image::FloatImage visibility = visibility_of(pictures.visibility);
  const auto compared = truth.compared(claim);
  look.errors = errors_of(visibility, traced, compared);
  pictures.error = image::heat_map(error_map(visibility, traced, compared));
}

void draw_in_full(gl::Graphics& graphics, const Job& job, double radius,
                  const image::Image& reference, Look& look) {
  graphics.meshes.sweep();
  forget_peak();
  const std::uint64_t held_before = held_bytes(graphics);
  const double began = now_ms();
  const auto recipe = recipe_of(graphics, job, radius, Shading::full);
  look.passes = summed(count_fill(graphics, *recipe));
  const image::Image picture = graphics.frame.read_color();
  look.first_frame = now_ms() - began;
  look.peak_bytes = peak();
  const std::uint64_t held_after = held_bytes(graphics);
  look.gl_bytes = held_after > held_before ? held_after - held_before : 0;
  look.triangles = recipe->work().triangles;
  look.draws = recipe->work().draws;
  look.upload_bytes = recipe->work().upload_bytes;
  const image::Flip flip = image::flip(reference, picture);
  look.flip_mean = flip.mean;
  look.flip_worst = flip.worst;
}

}  // namespace

Look look_at(gl::Graphics& graphics, const Job& job, GroundTruth& truth, double radius,
             LookPictures& pictures) {
  Look look;
  try {
    draw_visibility(graphics, job, truth, radius, look, pictures);
    if (look.left_out) return look;
    const auto radius_of_truth = look.soft ? std::optional(radius) : std::nullopt;
    draw_in_full(graphics, job, radius, truth.of(radius_of_truth).picture, look);
  } catch (const InputError& problem) {
    look.left_out = problem.what();
  }
  return look;
}

Round time(gl::Graphics& graphics, const Job& job, double radius, double milliseconds, int most) {
  Round round;
  const auto recipe = recipe_of(graphics, job, radius, Shading::full);
  recipe->draw();  // what is made once
  graphics.gl.Finish.unrecorded();
  const std::vector<std::string> rows = rows_of(recipe->passes()).names;
  const double end = now_ms() + milliseconds;
  do {
    const double began = now_ms();
    recipe->draw();
    graphics.gl.Finish.unrecorded();
    round.frames.push_back(now_ms() - began);
  } while (static_cast<int>(round.frames.size()) < most && now_ms() < end);
  recipe->start_timing_passes();
  round.passes.resize(rows.size());
  for (std::size_t i = 0; i < (round.frames.size() + 2) / 3; ++i) {
    recipe->draw();
    // Of a map that is kept the passes are missing now: what is left goes by its name.
    std::vector<double> sums(rows.size());
    for (const auto& pass : recipe->passes()) {
      auto row = std::ranges::find(rows, pass.name);
      if (row == rows.end()) row = std::ranges::find(rows, without_numbers(pass.name));
      if (row != rows.end())
        sums[static_cast<std::size_t>(row - rows.begin())] += pass.milliseconds;
    }
    for (std::size_t row = 0; row < sums.size(); ++row) round.passes[row].push_back(sums[row]);
  }
  return round;
}

}  // namespace shadowlab::measure
