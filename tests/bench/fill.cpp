// Each pass of the volume recipes against the fill limit of this machine, measured in the same run:
// the pixels that it covers times what a layer of them costs, against the time that it takes.
//
//   bench_fill [SCENE] [SIZE]
//
// "fill" is that ratio; "in all" the same where each triangle, and the pass itself, add their
// calibrated cost. docs/figures.md explains what is over 1.5.
#include <fmt/format.h>

#include <cstdlib>

#include "core/version.h"
#include "measure/fill.h"

int main(int argc, char** argv) {
  using namespace shadowlab;
  const std::string scene = argc > 1 ? argv[1] : "room";
  const int size = argc > 2 ? std::atoi(argv[2]) : 512;
  gl::Graphics graphics(context::create(), size, size);
  const auto limit = measure::fill_limit(graphics);
  fmt::print("a layer of 1 Mpix, ms:");
  for (std::size_t kind = 0; kind < measure::layer_count; ++kind)
    fmt::print("  {} {:.2f}", measure::name_of(static_cast<measure::Layer>(kind)),
               limit.layer[kind]);
  fmt::print("\na small triangle, ns: {:.0f}; a pass, ms: {:.3f}\n\n", limit.triangle, limit.pass);
  for (const std::string name :
       {"volumes_zpass", "volumes_two_sided", "volumes_zfail", "volumes_auto"}) {
    fmt::print("{:<58} {:>7} {:>9} {:>8} {:>8} {:>6} {:>7}\n", name, "Mpix", "triangles",
               "least ms", "ms", "fill", "in all");
    recipe::Options options;
    options.scene = scene;
    options.time_passes = true;
    recipe::Recipe recipe(graphics, home() / "scripts" / (name + ".lua"), std::move(options));
    for (const auto& pass : measure::fill_of(graphics, recipe)) {
      const double least = pass.least(limit);
      fmt::print("{:<58.58} {:>7.3f} {:>9} {:>8.3f} {:>8.3f} {:>6.2f} {:>7.2f}\n", pass.name,
                 pass.covered(), pass.triangles, least, pass.milliseconds,
                 least > 0 ? pass.milliseconds / least : 0,
                 least > 0 ? pass.milliseconds / pass.least_in_all(limit) : 0);
    }
    fmt::print("\n");
  }
}
