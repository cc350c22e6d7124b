// Cost curves: how a frame's time grows with one thing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measure/journal.h"
#include "measure/record.h"

namespace shadowlab::measure {

/// Milliseconds against what is varied.
struct Curve {
  std::string recipe;  ///< with the parameters that are not its own
  std::string scene;
  std::string of;  ///< "pixels", "triangles", "lights", or a parameter
  std::vector<Point> points;
};
Json record_of(const Curve& curve);

/// The curves that a sweep's points hold: of each number that a recipe sweeps, the other swept
/// parameters at the last of their values.
std::vector<Curve> swept_curves(const Json& points);

struct CurveOptions {
  std::vector<std::filesystem::path> recipes;
  std::string scene;             ///< of the curves of pixels
  std::vector<int> sides;        ///< pictures of side² pixels
  int side = 256;                ///< likewise, of the other curves
  std::vector<int> divisions;    ///< of a sphere, 4 n² triangles
  std::filesystem::path lights;  ///< the recipe that takes several lights
  std::vector<int> light_counts;
  double milliseconds = 60;  ///< of frames, a point and round
  int rounds = 2;
};

/// Every recipe with its own parameters over pictures of several sizes, and over a sphere of more
/// and more triangles on a floor; `lights` over more and more lights. What a recipe cannot draw is
/// left out. Contexts of their own; `journal` remembers.
std::vector<Curve> timed_curves(const CurveOptions& options, context::Backend backend,
                                Journal& journal, const std::function<void(std::string)>& step);

/// How many steps that tells of.
std::size_t steps_of(const CurveOptions& options);

}  // namespace shadowlab::measure
