// Mutants of the traces of the labs' solutions: each setting of GL's state with another constant,
// number or switch, one at a time, in all cases at once. What tests/bench/mutants.cpp finds by the
// source, this finds in what a frame really does: a call in a loop, or in a module, is here each
// time.
//
//   bench_trace_mutants [LAB…]     kill rate of each lab, and the mutants that live
#include <fmt/format.h>

#include <cctype>

#include "gl/replay.h"
#include "mutation.h"

namespace shadowlab::lab {
namespace {

using Calls = std::vector<Call>;

bool draws(const Call& call) { return call.function.starts_with("glDraw"); }

// Whether what call `i` sets is set anew before anything is drawn with it.
bool is_overwritten(const Calls& calls, std::size_t i) {
  const bool by_name = calls[i].function.find("able") != std::string::npos ||
                       calls[i].function.find("Separate") != std::string::npos ||
                       calls[i].function.find("Parameter") != std::string::npos;
  for (std::size_t k = i + 1; k < calls.size() && !draws(calls[k]); ++k) {
    if (calls[k].function == calls[i].function &&
        (!by_name || calls[k].arguments.front() == calls[i].arguments.front()))
      return true;
  }
  return false;
}

// What an argument is easily taken for.
std::vector<std::string> others_of(const std::string& argument) {
  if (argument == "GL_TRUE") return {"GL_FALSE"};
  if (argument == "GL_FALSE") return {"GL_TRUE"};
  for (const auto& family : families) {
    const auto found = std::find(family.begin(), family.end(),
                                 argument.starts_with("GL_") ? argument.substr(3) : "");
    if (found == family.end()) continue;
    std::vector<std::string> others;
    for (const std::string_view other : family) {
      if (other != *found) others.push_back(fmt::format("GL_{}", other));
    }
    return others;
  }
  if (argument.starts_with("0x")) return {"0x0"};
  if (argument.empty() || argument.find_first_not_of("0123456789.-fe") != std::string::npos)
    return {};
  const double value = std::strtod(argument.c_str(), nullptr);
  if (argument.find_first_of(".f") != std::string::npos)
    return {fmt::format("{:.6f}f", value * 1.5 + 0.1)};
  return {fmt::format("{}", static_cast<long>(value) + 1)};
}

// The calls that take the place of call `call`.
std::vector<Call> mutants_of(const Call& call) {
  std::vector<Call> mutants;
  if (call.function == "glEnable" || call.function == "glDisable") {
    mutants.push_back(call);
    mutants.back().function = call.function == "glEnable" ? "glDisable" : "glEnable";
    return mutants;
  }
  for (std::size_t a = 0; a < call.arguments.size(); ++a) {
    for (std::string& other : others_of(call.arguments[a])) {
      mutants.push_back(call);
      mutants.back().arguments[a] = std::move(other);
    }
  }
  return mutants;
}

std::string text_of(const Call& call) {
  return fmt::format("{}({})", call.function, fmt::join(call.arguments, ", "));
}

Counts run(const fs::path& folder) {
  Exam exam(folder, std::nullopt);
  const auto& cases = exam.reference().cases;
  const Calls& calls = cases.front().drawing().calls;
  Counts counts;
  std::string alive;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    if (calls[i].arguments.empty() || is_overwritten(calls, i) ||
        !gl::replay(exam.functions(), calls[i].function, calls[i].arguments))
      continue;
    const std::vector<Call> mutants = mutants_of(calls[i]);
    for (std::size_t m = 0; m < mutants.size(); ++m) {
      const Call& mutant = mutants[m];
      // In each case the same is done to what is set there: another map has another viewport.
      std::vector<std::vector<Change>> changes(cases.size());
      for (std::size_t c = 0; c < cases.size(); ++c) {
        const Calls& theirs = cases[c].drawing().calls;
        if (i >= theirs.size() || theirs[i].function != calls[i].function) continue;
        const std::vector<Call> like_it = mutants_of(theirs[i]);
        if (like_it.size() == mutants.size())
          changes[c].push_back({i, like_it[m].function, like_it[m].arguments});
      }
      Distance distance;
      const bool passes = exam.passes(exam.lab().solution(), distance, changes);
      ++counts.all;
      counts.dead += !passes;
      if (!passes) continue;
      counts.same += distance.pixels == 0;
      if (distance.pixels == 0) continue;
      alive += fmt::format("  pass {}: {} → {} ({} pixels, by {} at most)\n", calls[i].pass + 1,
                           text_of(calls[i]), text_of(mutant), distance.pixels, distance.most);
    }
  }
  fmt::print("{:<28} {}\n{}", exam.lab().name, counts.text(), alive);
  std::fflush(stdout);
  return counts;
}

}  // namespace
}  // namespace shadowlab::lab

int main(int argc, char** argv) {
  return shadowlab::lab::over_labs(argc, argv, shadowlab::lab::run);
}
