// A frame without the casters that shadow::plan drops.
#pragma once

#include <vector>

#include "lua/stage.h"

namespace shadowlab::recipe {

/// While it lives, the casters of `scene` whose shadows reach nothing that its camera sees are
/// receivers alone; nobody sees them, so nothing else changes.
class PlannedCasters {
 public:
  PlannedCasters(lua::Stage& stage, scene::Scene& scene, glm::dvec4 light);
  ~PlannedCasters();
  PlannedCasters(const PlannedCasters&) = delete;
  PlannedCasters& operator=(const PlannedCasters&) = delete;

 private:
  scene::Scene& scene_;
  std::vector<scene::Role> roles_;
};

}  // namespace shadowlab::recipe
