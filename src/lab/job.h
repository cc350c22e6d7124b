// What a recipe is asked to draw for a mark, and what it drew.
//
// A solution of ours is drawn in this process (draw); a submission in one of its own (worker.h),
// which is sent a Job and sends Drawings back. Neither references nor marks are ever in a Job.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/graphics.h"
#include "image/image.h"
#include "lua/state.h"
#include "scene/scene.h"

namespace shadowlab::lab {

/// A setting of state that is put before a draw, to see what would become of the picture.
struct Change {
  std::size_t call = 0;  ///< the draw's index in the trace of the frame without changes
  std::string function;  ///< as Call has them
  std::vector<std::string> arguments;
};

/// One picture that is asked for.
struct Shot {
  std::optional<std::string> scene = std::nullopt;  ///< in place of the recipe's own
  std::vector<std::pair<std::string, std::string>> settings =
      {};                                              ///< parameters, as --set takes them
  std::optional<scene::Camera> camera = std::nullopt;  ///< in place of the scene's
  std::vector<Change> changes = {};                    ///< in the order of their calls
};

/// The first passes and calls of a frame are kept, and no more: neither a lab nor a student has so
/// many, and what a submission makes us keep has to end.
inline constexpr std::size_t most_passes = 64, most_calls = 20'000;

/// Which of the main frame's buffers are kept of a moment. Each costs its reading and its way to
/// the grader, which is most of what a small picture costs.
struct Kept {
  bool color = false, depth = false, stencil = false;
  bool any() const { return color || depth || stencil; }
  bool operator==(const Kept&) const = default;
};
inline constexpr Kept everything{true, true, true};

struct Job {
  std::filesystem::path recipe;
  /// Files that belong to it, relative to its folder: shaders, modules, meshes.
  std::vector<std::filesystem::path> beside = {};
  int width = 256, height = 256;  ///< pixels
  std::vector<Shot> shots = {};
  Kept frame = everything;  ///< at its end
  Kept passes = {};         ///< after each pass
  bool calls = false;       ///< every GL call
  lua::Limits limits = {};
};

/// What the main frame's buffers held at one moment, as far as they were kept; rows from the top.
struct Buffers {
  std::string pass;  ///< the pass that had just ended; "" for the end of the frame
  image::Image color;
  image::FloatImage depth;  ///< window depth, 0 to 1
  std::vector<std::uint8_t> stencil;
};

/// One GL call of a frame, as C writes it.
struct Call {
  std::string function;                ///< "glStencilFunc"
  std::vector<std::string> arguments;  ///< "GL_ALWAYS", "1", "0xFF"
  int pass = -1;                       ///< index into passes, -1 outside of any
  std::string comment = {};            ///< what it is about: the uniform's name, the mesh
};

/// What came of one shot.
struct Drawing {
  std::optional<std::string> error;  ///< one sentence; the rest is then what came before it
  Buffers frame;                     ///< at its end
  std::vector<Buffers> passes;       ///< in their order, where the job keeps any of their buffers
  std::vector<Call> calls;           ///< where it asks for them
  std::string printed;
  double milliseconds = 0;
};

/// Draws the job's shots in their order in `graphics`, which has the job's size, and hands each
/// over to `each` as soon as it is drawn, without anything left of the one before. What is wrong
/// with the recipe is in the drawing, never thrown.
void draw(gl::Graphics& graphics, const Job& job,
          const std::function<void(std::size_t shot, Drawing)>& each);

}  // namespace shadowlab::lab
