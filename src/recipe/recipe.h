// A recipe: a Lua file that returns a table, its parameters, its scene, its frames and their
// passes.
//
//   gl::Graphics graphics(context::create(), 512, 512);
//   recipe::Recipe recipe(graphics, "scripts/projected_stencil.lua");
//   recipe.set("light", "2,4,1");
//   recipe.draw();                       // setup, before the first frame, is part of it
//   image::Image picture = graphics.frame.read_color();
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "gl/graphics.h"
#include "lua/boxes.h"
#include "lua/stage.h"
#include "lua/state.h"
#include "recipe/keys.h"

namespace shadowlab::recipe {

/// A parameter that `measure` varies, and the values that it gives it, as Recipe::set takes them.
struct Swept {
  std::string name;
  std::vector<std::string> values;
};

/// What a recipe says of itself.
struct Description {
  std::string title;
  std::string lecture;
  std::string scene;  ///< the scene's name; "" for a recipe without one
  /// What its picture is to be held against: "hard" or "soft" visibility, with " on receivers"
  /// where casters are not its business; "" where its picture is not visibility at all.
  std::string truth;
  std::vector<Swept> sweep;  ///< in alphabetical order
};

/// A parameter by its name, in alphabetical order.
struct NamedParameter {
  std::string name;
  lua::Parameter parameter;
};

/// One pass of the last frame.
struct PassTime {
  std::string name;
  double milliseconds = 0;  ///< between two glFinish, the pass alone
  gl::Work work;            ///< what the pass gave GL to do
};

/// Where a pixel of a recipe's picture may take its shadow from, by what its technique rounds: the
/// table that its function `limit` gives. Zero: from its own place alone.
struct Limit {
  double eye_units = 0;  ///< along the sight: steps of the 24-bit depth buffer
  double across = 0;  ///< across the light's rays: metres a metre from a point light, else metres
  double on_receiver = 0;  ///< along the surface itself, metres
  double light_units = 0;  ///< toward the light: steps of the map's depth,
  double light_near = 0;   ///< whose near plane this is (metres; 0: a light at infinity),
  double light_range = 0;  ///< and for a light at infinity the range of depths, metres
};

struct Options {
  lua::Limits limits;
  lua::PrintSink print;              ///< where print goes; nowhere if empty
  std::function<bool()> stop;        ///< see State::stop_when; never if empty
  std::optional<std::string> scene;  ///< in place of the recipe's own
  bool time_passes = false;          ///< glFinish around each pass
  bool explain = false;              ///< collect explanations()
  /// Told of the files that the recipe is made of: see State::on_file.
  std::function<void(const std::filesystem::path&)> on_file;
  /// Which casters are drawn: all, or those alone whose shadows may reach what is seen
  /// (lua/planned.h). The picture is the same.
  enum class Casters { all, planned } casters = Casters::all;
  /// What the stock shaders draw: their shading, or the visibility of the light alone, white where
  /// it reaches and black where it does not.
  enum class Shading { full, visibility } shading = Shading::full;
};

class Recipe : private lua::PassListener {
 public:
  /// Runs the file and loads its scene; draws nothing. Throws InputError for what is wrong with it.
  Recipe(gl::Graphics& graphics, const std::filesystem::path& file, Options options = {});
  ~Recipe() override;
  Recipe(const Recipe&) = delete;
  Recipe& operator=(const Recipe&) = delete;

  const Description& description() const { return description_; }
  const std::vector<NamedParameter>& parameters() const { return parameters_; }
  /// What keys do, in the order of the keys.
  const std::vector<KeyAction>& keys() const { return keys_; }
  const scene::Scene* scene() const { return scene_.get(); }
  lua::State& state() { return state_; }

  /// Sets a parameter from a text. Throws InputError for an unknown name, with the near one, or for
  /// a value that it does not take.
  void set(const std::string& name, const std::string& value);
  /// Sets the parameter "light" to any point (w = 1) or direction (w = 0), whichever of the two it
  /// is.
  void set_light(glm::dvec4 light);
  glm::dvec4 light() const;
  /// Another camera, in place of the scene's.
  void set_camera(const scene::Camera& camera);
  /// Another scene, camera and lights with it; before the first frame. Throws InputError for a
  /// recipe that has none.
  void set_scene(scene::Scene scene);
  /// Moves the scene's object of that name. Throws InputError where there is none.
  void set_model(std::string_view object, const glm::dmat4& model);

  /// Whether its setup ran.
  bool is_set_up() const { return set_up_; }
  /// Whether it asked for this parameter: what it made holds for that value alone.
  bool was_set_up_for(const std::string& parameter) const {
    return read_in_setup_.contains(parameter);
  }

  /// Whether the technique claims to be right for this camera and light: what the recipe's function
  /// `holds` says; true without one.
  bool holds();

  /// How far its technique may depart from the truth for this camera and light, by its own account.
  /// Throws InputError for a field that is none.
  Limit limit();

  /// The light's points whose hard shadows are averaged for its soft one, for this light: what the
  /// recipe's function `points` gives; none without one. Throws InputError for what is no light.
  std::vector<glm::dvec4> points();

  /// One frame at `time` seconds, into the main frame: GL's defaults, setup if it is the first,
  /// draw. Throws InputError where the recipe fails; the frame is then incomplete.
  void draw(double time = 0);

  /// Whether the last frame asked for r.time: any other moment would draw the same picture, if not.
  bool read_time() const { return read_time_; }

  /// The passes of the last frame, in their order; times where the options asked for them.
  std::span<const PassTime> passes() const { return {passes_.data(), pass_count_}; }

  /// From the next frame on glFinish is around each pass, as Options::time_passes asks from the
  /// first.
  void start_timing_passes() { time_passes_ = true; }

  /// What the last frame decided, and why, in its order; where the options asked for it.
  const std::vector<lua::Explanation>& explanations() const { return stage_.explanations; }
  /// What the whole of the last frame gave GL to do, setup apart.
  const gl::Work& work() const { return work_; }

  /// Called at the end of each pass with its index, while its results are in the buffers.
  void on_pass_end(std::function<void(std::size_t)> listener) { pass_ended_ = std::move(listener); }

 private:
  void begin_pass(std::string_view name) override;
  void end_pass() override;
  void read_table();
  void read_parameters(int table);
  void read_keys(int table);
  void load_scene(const std::optional<std::string>& override_name);
  void set_up();
  void push_context(double time);
  void push_parameters();
  void push_watched_parameters();
  static int look_up_in_context(lua_State* L);
  static int look_up_in_setup(lua_State* L);
  static int list_in_setup(lua_State* L);
  bool push_function(const char* name);
  void ask(const char* name, const std::function<void(lua_State*)>& take);

  gl::Graphics& graphics_;
  std::filesystem::path file_;
  bool time_passes_;
  lua::State state_;
  lua::Stage stage_;
  Description description_;
  std::vector<NamedParameter> parameters_;
  std::vector<KeyAction> keys_;
  lua::SceneBox scene_;
  std::vector<PassTime>
      passes_;  ///< the first pass_count_ are this frame's: names keep their storage
  std::size_t pass_count_ = 0;
  std::function<void(std::size_t)> pass_ended_;
  double pass_began_ = 0;
  gl::Work work_;
  gl::Work work_before_pass_;
  bool set_up_ = false;
  std::set<std::string, std::less<>> read_in_setup_;  ///< parameters
  double time_ = 0;                                   ///< r.time of this frame
  bool read_time_ = false;                            ///< it was asked for
  int scene_load_ = LUA_NOREF;
  int table_ = LUA_NOREF;    ///< the recipe's table, in Lua's registry
  int context_ = LUA_NOREF;  ///< r, which carries the recipe's resources from frame to frame
};

}  // namespace shadowlab::recipe
