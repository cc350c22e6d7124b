// A search for departures from the truth: worlds made at random, each drawn by techniques that
// claim to be exact but for a limit of their own, and what departs made as simple as it can be
// while it still does.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "gl/graphics.h"
#include "measure/sweep.h"
#include "measure/trial.h"

namespace shadowlab::measure {

/// A recipe, and parameters that it is given.
struct Searched {
  std::filesystem::path file;
  std::vector<std::pair<std::string, std::string>> settings;

  std::string name() const;
};

struct Departure {
  std::string recipe;
  std::uint64_t index = 0;      ///< of the trial that it was found in
  Trial trial;                  ///< the simplest that still departs
  std::size_t beyond_edge = 0;  ///< wrong pixels of that, beyond edges and the recipe's limit
  std::string error;            ///< the recipe's, where it fails instead
};

struct SearchOptions {
  std::vector<Searched> recipes;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< the first trial's number
  std::uint64_t trials = 100;
  /// No trial begins after so long.
  double most_seconds = std::numeric_limits<double>::infinity();
};

struct SearchResult {
  std::uint64_t trials = 0;
  std::uint64_t pictures = 0;  ///< compared: trials times recipes whose techniques hold there
  std::vector<Departure> departures;
};

/// Draws each trial with each recipe, and tells of each departure as it is found. Deterministic but
/// for `most_seconds`: the same options find the same.
SearchResult search(const SearchOptions& options,
                    const std::function<void(const Progress&)>& progress,
                    const std::function<void(const Departure&)>& found);

/// The simplest trial that `departs` still holds for, by steps of simpler(); at most `most` are
/// tried.
Trial shrunk(Trial trial, const std::function<bool(const Trial&)>& departs, int most = 400);

/// How many pixels `recipe` has wrong beyond an edge and beyond its own limit in the trial; nothing
/// where its technique does not claim to hold. `graphics` is of the trial's size. Throws InputError
/// where it fails.
std::optional<std::size_t> wrong_beyond_limit(gl::Graphics& graphics, const Searched& recipe,
                                              const Trial& trial);

}  // namespace shadowlab::measure
