// What isolation costs a submission of four 256 x 256 pictures, drawn and compared with a
// reference:
//
//   bench_worker [ROUNDS]
//
// in this process; by a worker that is warm (it has drawn the recipe of scripts/ on the same
// subject), without namespaces, and with four at once; by one that is cold (each submission
// compiles its own shaders); by a worker started for it alone. In turns, medians; how much
// processor time the child itself takes, and how much memory each has. What the usual script takes
// in place of all this, tests/bench/grading.sh prints.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/version.h"
#include "image/difference.h"
#include "lab/worker.h"
#include "measure/median.h"

namespace {

using namespace shadowlab;
using Namespaces = lab::Isolation::Namespaces;

constexpr std::array lights{"2,4,1", "0,4,0", "-1,3,2", "1,5,-2"};
constexpr int at_once = 4;

class Submission {
 public:
  Submission() {
    for (const char* light : lights) job_.shots.push_back({.settings = {{"light", light}}});
    lab::draw(graphics_, job_, [this](std::size_t, const lab::Drawing& drawing) {
      references_.push_back(drawing.frame.color);
    });
  }

  void here() {
    peak_ = 0;
    processor_ms_ = 0;
    lab::draw(graphics_, job_,
              [this](std::size_t i, const lab::Drawing& drawing) { mark(i, drawing); });
  }
  void by(lab::Worker& worker) {
    const auto outcome =
        worker.draw(job_, [this](std::size_t i, const lab::Drawing& drawing) { mark(i, drawing); });
    if (outcome.verdict != lab::Verdict::finished) fail(outcome.sentence);
    peak_ = outcome.peak_memory;
    processor_ms_ = outcome.processor_seconds * 1000;
  }
  void several_by(lab::Worker& worker) {
    std::vector<std::jthread> threads;
    threads.reserve(at_once);
    for (int i = 0; i < at_once; ++i) threads.emplace_back([&] { by(worker); });
  }

  lab::Isolation isolation(bool warm, Namespaces namespaces = Namespaces::where_allowed) const {
    lab::Isolation isolation{.namespaces = namespaces, .program = SHADOWLAB_PROGRAM};
    if (warm) isolation.warm = {job_.recipe};
    return isolation;
  }
  std::size_t peak() const { return peak_; }
  double processor_ms() const { return processor_ms_; }

 private:
  [[noreturn]] static void fail(const std::string& why) {
    fmt::print(stderr, "{}\n", why);
    std::exit(1);
  }
  void mark(std::size_t i, const lab::Drawing& drawing) const {
    if (image::compare(drawing.frame.color, references_[i], 3).differing != 0)
      fail("a picture differs from its reference");
  }

  // As a grader asks for it.
  lab::Job job_{.recipe = home() / "scripts" / "projected_stencil.lua",
                .frame = {.color = true},
                .calls = true};
  gl::Graphics graphics_{context::create(), 256, 256};
  std::vector<image::Image> references_;
  std::atomic<std::size_t> peak_ = 0;
  std::atomic<double> processor_ms_ = 0;
};

struct Way {
  const char* name;
  std::function<void()> work;
  int submissions = 1;
  std::vector<double> times = {}, processor_times = {};
  std::size_t peak = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 15;
  Submission one;
  lab::Worker warm(one.isolation(true)), cold(one.isolation(false)),
      bare(one.isolation(true, Namespaces::none));
  std::vector<Way> ways{{"in this process, warm", [&] { one.here(); }},
                        {"worker, warm", [&] { one.by(warm); }},
                        {"worker, warm, no namespaces", [&] { one.by(bare); }},
                        {"worker, warm, four at once", [&] { one.several_by(warm); }, at_once},
                        {"worker, cold", [&] { one.by(cold); }},
                        {"a worker for each, cold", [&] {
                           lab::Worker own(one.isolation(false));
                           one.by(own);
                         }}};
  for (int round = -1; round < rounds; ++round) {
    for (Way& way : ways) {
      const auto begin = std::chrono::steady_clock::now();
      way.work();
      const std::chrono::duration<double, std::milli> spent =
          std::chrono::steady_clock::now() - begin;
      if (round < 0) continue;  // what is warm gets so
      way.times.push_back(spent.count() / way.submissions);
      way.processor_times.push_back(one.processor_ms());
      way.peak = one.peak();
    }
  }
  fmt::print("isolated by {}\n\n", lab::names_of(warm.layers()));
  fmt::print("{:<30} {:>15} {:>9} {:>9} {:>10} {:>9}\n", "", "ms a submission", "a second",
             "more ms", "child's ms", "MiB");
  const double base = measure::median(ways[0].times);
  for (Way& way : ways) {
    const double time = measure::median(way.times);
    const double child = measure::median(way.processor_times);
    fmt::print("{:<30} {:>15.1f} {:>9.1f} {:>9.1f} {:>10} {:>9}\n", way.name, time, 1e3 / time,
               time - base, child > 0 ? fmt::format("{:.1f}", child) : "",
               way.peak == 0 ? "" : fmt::format("{}", way.peak >> 20));
  }
}
