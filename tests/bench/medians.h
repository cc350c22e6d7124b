// Medians of interleaved repetitions: what a table of ratios is made of.
//
// Absolute times drift on a shared machine; runs that alternate drift together.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace shadowlab::bench {

enum class Clock { processor, wall };

class Medians : public benchmark::BenchmarkReporter {
 public:
  explicit Medians(Clock clock) : clock_(clock) {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double seconds =
          clock_ == Clock::processor ? run.cpu_accumulated_time : run.real_accumulated_time;
      samples_[run.run_name.function_name].push_back(seconds / static_cast<double>(run.iterations));
    }
  }

  /// Seconds an iteration of that benchmark; 0 if it did not run.
  double median(const std::string& name) {
    std::vector<double>& samples = samples_[name];
    if (samples.empty()) return 0;
    const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::nth_element(samples.begin(), middle, samples.end());
    return *middle;
  }

 private:
  Clock clock_;
  std::map<std::string, std::vector<double>> samples_;
};

/// Runs all benchmarks, their repetitions interleaved; the command line may say otherwise.
inline void run_interleaved(int argc, char** argv, Medians& medians, const char* repetitions,
                            const char* min_time) {
  std::vector<std::string> words{argv[0], repetitions,
                                 "--benchmark_enable_random_interleaving=true", min_time};
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  benchmark::RunSpecifiedBenchmarks(&medians);
}

}  // namespace shadowlab::bench
