// How mutants of a lab's solution are judged: those that lose marks die, those that draw the same
// to the last bit are none.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/version.h"
#include "lab/grade.h"

namespace shadowlab::lab {

namespace fs = std::filesystem;

// What is easily taken for one another.
inline const std::vector<std::vector<std::string_view>> families{
    {"NEVER", "LESS", "EQUAL", "LEQUAL", "GREATER", "NOTEQUAL", "GEQUAL", "ALWAYS"},
    {"KEEP", "ZERO", "REPLACE", "INCR_WRAP", "DECR_WRAP", "INVERT", "INCR", "DECR"},
    {"FRONT", "BACK"},
    {"ONE", "SRC_ALPHA", "ONE_MINUS_SRC_ALPHA", "DST_COLOR"},
    {"COLOR_BUFFER_BIT", "DEPTH_BUFFER_BIT", "STENCIL_BUFFER_BIT"},
    {"DEPTH_TEST", "STENCIL_TEST", "CULL_FACE", "BLEND", "POLYGON_OFFSET_FILL"},
    {"NEAREST", "LINEAR"},
    {"CLAMP_TO_EDGE", "REPEAT", "CLAMP_TO_BORDER"},
    {"ACCUM", "LOAD", "ADD", "MULT", "RETURN"},
    {"CW", "CCW"},
};

struct Counts {
  std::size_t all = 0, same = 0, dead = 0;
  std::string text() const {
    const std::size_t changed = all - same;
    return fmt::format("{:>4} of {:>4} die, {:.1f} %; {} more draw the same", dead, changed,
                       100.0 * static_cast<double>(dead) / static_cast<double>(changed), same);
  }
};

// How far the pixels of two pictures are from each other.
struct Distance {
  std::size_t pixels = 0;
  int most = 0;  // of 255
  void add(const image::Image& a, const image::Image& b) {
    for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); i += 4) {
      int pixel = 0;
      for (std::size_t c = i; c < i + 3; ++c)
        pixel = std::max(pixel, std::abs(int{a.rgba[c]} - int{b.rgba[c]}));
      pixels += pixel > 0;
      most = std::max(most, pixel);
    }
  }
};

// One lab with one seed's cases.
class Exam {
 public:
  Exam(const fs::path& folder, std::optional<std::uint64_t> seed)
      : lab_(load_lab(folder, seed)), graphics_(context::create(), lab_.width, lab_.height) {
    lab_.mistakes.clear();  // nobody reads the hints here
    reference_.emplace(draw_reference(graphics_, lab_));
  }
  const Lab& lab() const { return lab_; }

  const Reference& reference() const { return *reference_; }
  const gl::Functions& functions() const { return graphics_.gl; }

  /// Whether the recipe has all marks, each case with its changes of state, where there are any.
  bool passes(const fs::path& recipe, Distance& from_solution,
              const std::vector<std::vector<Change>>& changes = {}) {
    graphics_.context().make_current();
    const DrawSubmission in_process = [&](const Job& job, const auto& each) {
      if (job.passes == everything || !job.shots.front().changes.empty())
        return Drawn{};  // for a hint
      Job changed = job;
      for (std::size_t i = 0; i < changes.size(); ++i) changed.shots[i].changes = changes[i];
      draw(graphics_, changed, [&](std::size_t i, Drawing drawing) {
        from_solution.add(drawing.frame.color, reference_->cases[i].drawing().frame.color);
        each(i, std::move(drawing));
      });
      return Drawn{};
    };
    return grade(lab_, *reference_, {"mutant", recipe, {}, {}}, in_process, {}).passed();
  }

 private:
  Lab lab_;
  gl::Graphics graphics_;
  std::optional<Reference> reference_;
};

/// The labs of those names, or all.
inline std::set<fs::path> labs_named(int argc, char** argv) {
  std::set<fs::path> labs;
  for (int i = 1; i < argc; ++i) labs.insert(home() / "labs" / argv[i]);
  if (!labs.empty()) return labs;
  for (const auto& entry : fs::directory_iterator(home() / "labs")) {
    if (exists(entry.path() / "lab.lua")) labs.insert(entry.path());
  }
  return labs;
}

/// Runs `one` over the labs, and prints their sum.
template <class One>
int over_labs(int argc, char** argv, const One& one) {
  Counts sum;
  for (const fs::path& folder : labs_named(argc, argv)) {
    const Counts counts = one(folder);
    sum.all += counts.all;
    sum.same += counts.same;
    sum.dead += counts.dead;
  }
  fmt::print("{:<28} {}\n", "all", sum.text());
  return 0;
}

}  // namespace shadowlab::lab
