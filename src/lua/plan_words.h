// A plan in words, for `shadowlab run --explain`.
#pragma once

#include "lua/planned.h"
#include "lua/stage.h"
#include "shadow/plan.h"

namespace shadowlab::lua {

/// Reasons where somebody asks for them.
inline shadow::Reasons reasons_for(const Stage& stage) {
  return stage.explaining ? shadow::Reasons::told : shadow::Reasons::none;
}

/// What was kept and dropped, why, and the pixels, triangles and bytes that it saves against z-fail
/// for all casters. The volumes of dropped casters are built to be counted: for explanations alone.
void explain_plan(Stage& stage, const scene::Scene& scene, glm::dvec4 light,
                  const shadow::Plan& plan);

/// What a planned frame left out, and why.
void explain_planned(Stage& stage);

}  // namespace shadowlab::lua
