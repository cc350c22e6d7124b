// What the bindings of one Lua state work on.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gl/graphics.h"
#include "lua/state.h"
#include "scene/scene.h"

namespace shadowlab::lua {

class VolumePool;
class TruthPool;
class Planned;

/// Told of every pass(name, fn) that a recipe runs.
class PassListener {
 public:
  virtual ~PassListener() = default;
  virtual void begin_pass(std::string_view name) = 0;
  virtual void end_pass() = 0;
};

/// A decision that a recipe or the core took, with its reason: one sentence.
struct Explanation {
  std::string pass;  ///< where it was taken; empty outside of any
  std::string text;
};

/// The things that gl.*, meshes, shaders and scenes act on. It outlives its State's scripts; one
/// for each State, kept in Lua's registry.
struct Stage {
  State& state;
  gl::Graphics& graphics;
  PassListener* passes = nullptr;
  /// The pass that is running, for error sentences; empty outside of any.
  std::string pass_name;
  /// Where files that a recipe names are looked for, first to last: beside it, then shadowlab's
  /// own.
  std::vector<std::filesystem::path> folders;
  /// The GL objects that scripts made by gl.Gen* and their like.
  gl::Objects objects = {};
  /// The shadow volumes that the recipe asked for.
  std::shared_ptr<VolumePool> volumes = nullptr;
  std::shared_ptr<TruthPool> truths = nullptr;
  /// What a planned frame leaves out; absent: nothing.
  std::shared_ptr<Planned> planned = nullptr;
  /// Whether anybody asks why; else nothing is put into words.
  bool explaining = false;
  /// This frame's, in their order; what was said before is not said again.
  std::vector<Explanation> explanations = {};
  std::size_t explained_in_setup = 0;  ///< the first ones, which every frame has
  void explain(std::string text);
  /// The picture, where it is not all of the main frame but its lower left corner: pixels.
  std::optional<glm::ivec2> corner = std::nullopt;
  glm::ivec2 picture_size() const {
    return corner.value_or(glm::ivec2(graphics.width(), graphics.height()));
  }
  /// Picture width over height, which mesh and scene functions need for projections.
  double aspect() const {
    const glm::ivec2 size = picture_size();
    return static_cast<double>(size.x) / static_cast<double>(size.y);
  }

  static Stage& of(lua_State* L);
  /// Makes `stage` the state's; call it once, before the bindings are opened.
  static void install(lua_State* L, Stage& stage);
};

/// Opens every module: vec2 … quat, gl, shader, mesh, scene, shadow, fbo, pass, param.
void open_all(Stage& stage);

/// What was given out for the last frame may be used again for this one.
void begin_frame(Stage& stage);
/// What setup was given stays.
void end_setup(Stage& stage);

void open_gl(Stage& stage);
void open_shader(Stage& stage);
void open_mesh(Stage& stage);
void open_scene(Stage& stage);
void open_shadow(Stage& stage);
void open_pass(Stage& stage);
void open_param(Stage& stage);
void open_fbo(Stage& stage);

/// The file that a recipe means by `name`, in the first of the stage's folders that has it. Throws
/// InputError for absolute names, for names that lead out of the folder (.. or symbolic links), and
/// where no folder has it; the message never quotes what a file contains.
std::filesystem::path find_file(const Stage& stage, const std::string& name);

}  // namespace shadowlab::lua
