// The truths of one scene under its own camera and light, each traced once for all techniques.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "gl/graphics.h"
#include "measure/claim.h"
#include "measure/errors.h"

namespace shadowlab::measure {

/// A truth with what it cost, and the picture that a technique without error would draw.
struct TracedTruth : Truth {
  std::uint64_t rays = 0;
  double milliseconds = 0;
  std::size_t unconverged = 0;  ///< pixels whose error bar is above the one asked for
  image::Image picture;         ///< by the reference recipe
};

class GroundTruth {
 public:
  /// Of the scene as `reference` has it: a recipe whose picture is the truth, with the parameters
  /// light, radius and samples (scripts/truth.lua). `bar` is the standard error that soft
  /// visibility may have in a pixel.
  GroundTruth(gl::Graphics& graphics, std::filesystem::path reference, std::string scene,
              double bar);

  const scene::Scene& scene() const { return scene_; }
  glm::dvec4 light() const { return light_; }

  /// For a light of that radius; absent or 0: the hard one.
  const TracedTruth& of(std::optional<double> radius);

  /// 1 where the claim covers what a pixel sees.
  std::vector<std::uint8_t> compared(const Claim& claim) const;

 private:
  TracedTruth trace(double radius);
  image::Image draw_reference(double radius);

  gl::Graphics& graphics_;
  std::filesystem::path reference_;
  std::string scene_name_;
  double bar_;
  scene::Scene scene_;
  glm::dvec4 light_{0};
  std::optional<truth::Tracer> tracer_;
  truth::SurfaceImage surfaces_;
  std::map<double, TracedTruth> truths_;
};

}  // namespace shadowlab::measure
