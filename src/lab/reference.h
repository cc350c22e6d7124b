// What a submission is held against: the solution and the mistakes of a lab, drawn in this run by
// the driver of this machine, and the exact truth of each case.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "lab/compare.h"
#include "lab/manifest.h"

namespace shadowlab::lab {

/// What of the picture is where, by the exact truth.
struct Regions {
  PixelMask edge;    ///< within a pixel of an edge of a shadow, or between two surfaces
  PixelMask shadow;  ///< a surface that the light does not reach
  PixelMask ground;  ///< no surface at all
};

/// One case of the solution. From any thread.
class ReferenceCase {
 public:
  ReferenceCase(Drawing drawing, std::optional<std::pair<scene::Scene, scene::Light>> scene)
      : drawing_(std::move(drawing)), scene_(std::move(scene)) {}

  const Drawing& drawing() const { return drawing_; }
  /// Traced when first asked for: a class whose submissions are right needs none. Without a scene
  /// and a light, the edges are those that the reference's own picture and depth have.
  const Regions& regions() const;
  /// Whether there is a truth beside the picture itself.
  bool has_truth() const { return scene_.has_value(); }

 private:
  Drawing drawing_;
  std::optional<std::pair<scene::Scene, scene::Light>> scene_;
  mutable std::once_flag traced_;
  mutable Regions regions_;
};

struct Reference {
  std::deque<ReferenceCase> cases;             ///< as Lab::cases
  std::vector<std::vector<Drawing>> mistakes;  ///< of each Lab::mistakes, each case
  std::string driver;                          ///< GL_RENDERER
};

/// Draws them in `graphics`, which has the lab's size. Throws InputError where the solution fails,
/// or has no pass that a case names.
Reference draw_reference(gl::Graphics& graphics, const Lab& lab);

/// The pass of that name; else one whose name differs only in its number, spaces and capitals; -1.
int find_pass(const std::vector<Buffers>& passes, const std::string& name);

}  // namespace shadowlab::lab
