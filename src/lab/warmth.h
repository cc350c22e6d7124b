// Shaders and the driver's code for them, compiled before there is a submission: for speed alone.
#pragma once

#include <filesystem>
#include <span>

#include "gl/graphics.h"

namespace shadowlab::lab {

/// What is compiled beforehand.
enum class Warmth {
  recipes,  ///< what the recipes themselves draw with
  /// And each of their shaders under the states that the lectures use. llvmpipe compiles a shader
  /// anew for each: a second or so, which pays where many submissions follow. The states are the
  /// same for every lab, so that they tell nothing of its solution.
  states,
};

/// Draws each recipe once. One that fails is not warm, and nothing else.
void warm_up(gl::Graphics& graphics, std::span<const std::filesystem::path> recipes, Warmth warmth);

}  // namespace shadowlab::lab
