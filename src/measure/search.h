// A search for departures from the truth: worlds made at random, each drawn by techniques that
// claim to be exact, and what departs made as simple as it can be while it still does.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "gl/graphics.h"
#include "measure/sweep.h"
#include "measure/trial.h"

namespace shadowlab::measure {

struct Departure {
  std::string recipe;
  std::uint64_t index = 0;      ///< of the trial that it was found in
  Trial trial;                  ///< the simplest that still departs
  std::size_t beyond_edge = 0;  ///< wrong pixels of that, farther than a pixel from an edge
  std::string error;            ///< the recipe's, where it fails instead
};

struct SearchOptions {
  std::vector<std::filesystem::path> recipes;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< the first trial's number
  std::uint64_t trials = 100;
};

/// Draws each trial with each recipe in `graphics`, and tells of each departure as it is found.
/// Deterministic: the same options find the same.
std::vector<Departure> search(gl::Graphics& graphics, const SearchOptions& options,
                              const std::function<void(const Progress&)>& progress,
                              const std::function<void(const Departure&)>& found);

/// The simplest trial that `departs` still holds for, by steps of simpler(); at most `most` are
/// tried.
Trial shrunk(Trial trial, const std::function<bool(const Trial&)>& departs, int most = 400);

/// How many pixels `recipe` has wrong beyond an edge in the trial; nothing where its technique does
/// not claim to hold. Throws InputError where it fails.
std::optional<std::size_t> wrong_beyond_edge(gl::Graphics& graphics,
                                             const std::filesystem::path& recipe,
                                             const Trial& trial);

}  // namespace shadowlab::measure
