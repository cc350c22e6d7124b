#include "recipe/recipe.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/clock.h"
#include "core/error.h"
#include "core/near_names.h"
#include "core/version.h"
#include "lua/plan_words.h"
#include "lua/value.h"

namespace shadowlab::recipe {
namespace {

constexpr std::size_t most_passes = 10'000;

// Where files are looked for: beside the recipe, then shadowlab's own.
std::vector<std::filesystem::path> folders(const std::filesystem::path& recipe_folder,
                                           Options::Shading shading) {
  std::vector<std::filesystem::path> list{recipe_folder, home() / "scripts"};
  if (shading == Options::Shading::visibility) list.push_back(home() / "shaders" / "visibility");
  list.push_back(home() / "shaders");
  return list;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

Recipe::Recipe(gl::Graphics& graphics, const std::filesystem::path& file, Options options)
    : graphics_(graphics),
      file_(file),
      time_passes_(options.time_passes),
      state_(
          options.limits, options.print ? options.print : [](std::string_view) {}),
      stage_{state_, graphics, this, {}, folders(folder_of(file), options.shading)} {
  stage_.explaining = options.explain;
  if (options.casters == Options::Casters::planned)
    stage_.planned = std::make_shared<lua::Planned>();
  graphics_.begin_frame();
  state_.on_file(options.on_file);
  state_.stop_when(options.stop);
  state_.search_in({folder_of(file), home() / "scripts"});
  try {
    state_.run([&](lua_State* L) {
      lua::open_all(stage_);
      lua_getglobal(L, "scene");  // the script's own, once it has run
      lua_getfield(L, -1, "load");
      scene_load_ = luaL_ref(L, LUA_REGISTRYINDEX);
      if (const auto problem = state_.try_load_file(L, file_)) throw InputError(*problem);
      lua_call(L, 0, 1);
      read_table();
      load_scene(options.scene);
    });
  } catch (...) {
    graphics_.forget(stage_.objects);
    throw;
  }
}

Recipe::~Recipe() { graphics_.forget(stage_.objects); }

void Recipe::load_scene(const std::optional<std::string>& override_name) {
  const std::string name = override_name.value_or(description_.scene);
  if (name.empty()) return;
  lua_State* L = state_.raw();
  lua_rawgeti(L, LUA_REGISTRYINDEX, scene_load_);
  lua_pushstring(L, name.c_str());
  lua_call(L, 1, 1);
  scene_ = lua::read_box<lua::SceneBox>(L, -1, "the scene");
  description_.scene = name;
  lua_rawgeti(L, LUA_REGISTRYINDEX, context_);
  lua_insert(L, -2);
  lua_setfield(L, -2, "scene");
  lua_pop(L, 1);
  // Another scene brings its own light: the recipe's default was chosen for its own scene.
  const bool has_light = std::any_of(parameters_.begin(), parameters_.end(),
                                     [](const auto& known) { return known.name == "light"; });
  if (override_name && has_light && !scene_->lights.empty()) set_light(scene_->lights[0].position);
}

void Recipe::set(const std::string& name, const std::string& value) {
  std::vector<std::string_view> names;
  for (NamedParameter& known : parameters_) {
    if (known.name == name) return lua::set_value(known.parameter, name, value);
    names.push_back(known.name);
  }
  throw InputError(
      fmt::format("{} has no parameter {}{}", file_.string(), name, did_you_mean(name, names)));
}

void Recipe::set_light(glm::dvec4 light) {
  for (NamedParameter& known : parameters_) {
    if (known.name != "light") continue;
    known.parameter.kind =
        light.w == 0 ? lua::Parameter::Kind::direction : lua::Parameter::Kind::point;
    const double w = light.w == 0 ? 1 : light.w;
    known.parameter.value = {light.x / w, light.y / w, light.z / w};
    return;
  }
  throw InputError(fmt::format("{} has no parameter light", file_.string()));
}

glm::dvec4 Recipe::light() const {
  for (const NamedParameter& known : parameters_) {
    if (known.name != "light" || known.parameter.value.size() != 3) continue;
    const auto& v = known.parameter.value;
    return {v[0], v[1], v[2], known.parameter.kind == lua::Parameter::Kind::direction ? 0 : 1};
  }
  throw InputError(fmt::format("{} has no parameter light", file_.string()));
}

void Recipe::set_camera(const scene::Camera& camera) {
  if (scene_) scene_->camera = camera;
}

void Recipe::set_scene(scene::Scene scene) {
  if (!scene_) throw InputError(fmt::format("{} has no scene", file_.string()));
  *scene_ = std::move(scene);
}

void Recipe::set_model(std::string_view name, const glm::dmat4& model) {
  if (scene_) {
    for (scene::Object& object : scene_->objects) {
      if (object.name != name) continue;
      object.model = model;
      return;
    }
  }
  throw InputError(fmt::format("the scene of {} has no object {}", file_.string(), name));
}

// r, with this frame's parameters, size and time.
void Recipe::push_context(double time) {
  lua_State* L = state_.raw();
  lua_rawgeti(L, LUA_REGISTRYINDEX, context_);
  push_parameters();
  lua_setfield(L, -2, "params");
  lua_pushinteger(L, graphics_.width());
  lua_setfield(L, -2, "width");
  lua_pushinteger(L, graphics_.height());
  lua_setfield(L, -2, "height");
  time_ = time;
}

void Recipe::push_parameters() {
  lua_State* L = state_.raw();
  lua_createtable(L, 0, static_cast<int>(parameters_.size()));
  for (const NamedParameter& known : parameters_) {
    lua::push_value(L, known.parameter);
    lua_setfield(L, -2, known.name.c_str());
  }
}

// The parameters as setup has them: a table that holds none, so that it is known which it asks for.
void Recipe::push_watched_parameters() {
  lua_State* L = state_.raw();
  lua_newtable(L);
  lua_newtable(L);
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, look_up_in_setup, 1);
  lua_setfield(L, -2, "__index");
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, list_in_setup, 1);
  lua_setfield(L, -2, "__pairs");
  lua::lock_metatable(L, lua_gettop(L));
  lua_setmetatable(L, -2);
}

int Recipe::look_up_in_setup(lua_State* L) {
  auto* const recipe = static_cast<Recipe*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string_view name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  for (const NamedParameter& known : recipe->parameters_) {
    if (known.name != name) continue;
    recipe->read_in_setup_.insert(known.name);
    lua::push_value(L, known.parameter);
    return 1;
  }
  return 0;
}

int Recipe::list_in_setup(lua_State* L) {
  auto* const recipe = static_cast<Recipe*>(lua_touserdata(L, lua_upvalueindex(1)));
  for (const NamedParameter& known : recipe->parameters_) recipe->read_in_setup_.insert(known.name);
  lua_getglobal(L, "pairs");
  recipe->push_parameters();
  lua_call(L, 1, 3);
  return 3;
}

// r.time, which r does not hold, so that it is known who asks for it.
int Recipe::look_up_in_context(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING || std::string_view(lua_tostring(L, 2)) != "time") return 0;
  auto* const recipe = static_cast<Recipe*>(lua_touserdata(L, lua_upvalueindex(1)));
  recipe->read_time_ = true;
  lua_pushnumber(L, recipe->time_);
  return 1;
}

bool Recipe::push_function(const char* name) {
  lua_State* L = state_.raw();
  lua_rawgeti(L, LUA_REGISTRYINDEX, table_);
  return lua_getfield(L, -1, name) == LUA_TFUNCTION;
}

void Recipe::set_up() {
  const gl::Untraced untraced(graphics_.calls());  // a trace is of the frame
  state_.restart_budget();
  state_.run([&](lua_State* L) {
    if (!push_function("setup")) return;
    push_context(0);
    push_watched_parameters();
    lua_setfield(L, -2, "params");
    lua_call(L, 1, 0);
  });
  lua::end_setup(stage_);
  set_up_ = true;
}

void Recipe::draw(double time) {
  lua::begin_frame(stage_);
  if (!set_up_) {
    set_up();
    lua::begin_frame(stage_);
    graphics_.clear_buffers();
  }
  pass_count_ = 0;
  read_time_ = false;
  if (gl::Recorder* recorder = graphics_.recorder())
    recorder->end_pass();  // of a frame that failed
  state_.restart_budget();
  const gl::Work before = graphics_.calls().work;
  state_.run([&](lua_State* L) {
    push_function("draw");
    push_context(time);
    lua_call(L, 1, 0);
  });
  work_ = graphics_.calls().work - before;
  if (stage_.planned && stage_.explaining) lua::explain_planned(stage_);
}

void Recipe::begin_pass(std::string_view name) {
  if (!set_up_) return;  // a step of setup is none of the frame
  if (pass_count_ >= most_passes)
    throw InputError(fmt::format("a frame has at most {} passes", most_passes));
  if (pass_count_ == passes_.size()) passes_.emplace_back();
  PassTime& pass = passes_[pass_count_++];
  pass.name = name;
  pass.milliseconds = 0;
  work_before_pass_ = graphics_.calls().work;
  if (gl::Recorder* recorder = graphics_.recorder()) recorder->begin_pass(std::string(name));
  if (!time_passes_) return;
  graphics_.gl.Finish.unrecorded();
  pass_began_ = now_ms();
}

void Recipe::end_pass() {
  if (!set_up_) return;
  if (time_passes_) {
    graphics_.gl.Finish.unrecorded();
    passes_[pass_count_ - 1].milliseconds = now_ms() - pass_began_;
  }
  passes_[pass_count_ - 1].work = graphics_.calls().work - work_before_pass_;
  if (gl::Recorder* recorder = graphics_.recorder()) recorder->end_pass();
  if (pass_ended_) pass_ended_(pass_count_ - 1);
}

}  // namespace shadowlab::recipe
