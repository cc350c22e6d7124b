#include "recipe/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/near_names.h"
#include "core/version.h"
#include "lua/value.h"

namespace shadowlab::recipe {
namespace {

double now() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

std::string text_field(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  const std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
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
      stage_{
          state_, graphics, this, {}, {folder_of(file), home() / "scripts", home() / "shaders"}} {
  graphics_.begin_frame();
  state_.search_in({folder_of(file), home() / "scripts"});
  lua::open_all(stage_);
  state_.load_file(file_);
  state_.call(0, 1);
  read_table();
  load_scene(options.scene);
}

Recipe::~Recipe() {
  graphics_.context().make_current();
  graphics_.forget_recipe();
}

void Recipe::read_table() {
  lua_State* L = state_.raw();
  if (lua_type(L, -1) != LUA_TTABLE) {
    throw InputError(
        fmt::format("{}: a recipe returns a table with a function draw; this file returns {}",
                    file_.string(), lua::describe(L, -1)));
  }
  const int table = lua_gettop(L);
  lua_getfield(L, table, "draw");
  if (!lua_isfunction(L, -1)) {
    throw InputError(
        fmt::format("{}: the recipe has no function draw; write function recipe.draw(r) … end",
                    file_.string()));
  }
  lua_pop(L, 1);
  description_ = {text_field(L, table, "title"), text_field(L, table, "lecture"),
                  text_field(L, table, "scene")};
  if (description_.title.empty()) description_.title = file_.stem().string();
  read_parameters(table);
  table_ = luaL_ref(L, LUA_REGISTRYINDEX);
  lua_newtable(L);
  context_ = luaL_ref(L, LUA_REGISTRYINDEX);
}

void Recipe::read_parameters(int table) {
  lua_State* L = state_.raw();
  lua_getfield(L, table, "params");
  if (lua_type(L, -1) == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      const std::string name =
          lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : lua::describe(L, -2);
      const auto* parameter = lua::test_box<lua::Parameter>(L, -1);
      if (!parameter) {
        throw InputError(fmt::format(
            "{}: params.{} must be made by param.point, param.number and their like; it is {}",
            file_.string(), name, lua::describe(L, -1)));
      }
      parameters_.push_back({name, *parameter});
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    throw InputError(
        fmt::format("{}: params must be a table; it is {}", file_.string(), lua::describe(L, -1)));
  }
  lua_pop(L, 1);
  std::sort(parameters_.begin(), parameters_.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
}

void Recipe::load_scene(const std::optional<std::string>& override_name) {
  const std::string name = override_name.value_or(description_.scene);
  if (name.empty()) return;
  lua_State* L = state_.raw();
  lua_getglobal(L, "scene");
  lua_getfield(L, -1, "load");
  lua_remove(L, -2);
  lua_pushstring(L, name.c_str());
  state_.call(1, 1);
  scene_ = lua::read_box<lua::SceneBox>(L, -1, "the scene");
  description_.scene = name;
  lua_rawgeti(L, LUA_REGISTRYINDEX, context_);
  lua_insert(L, -2);
  lua_setfield(L, -2, "scene");
  lua_pop(L, 1);
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

// r, with this frame's parameters, size and time.
void Recipe::push_context(double time) {
  lua_State* L = state_.raw();
  lua_rawgeti(L, LUA_REGISTRYINDEX, context_);
  lua_createtable(L, 0, static_cast<int>(parameters_.size()));
  for (const NamedParameter& known : parameters_) {
    lua::push_value(L, known.parameter);
    lua_setfield(L, -2, known.name.c_str());
  }
  lua_setfield(L, -2, "params");
  lua_pushinteger(L, graphics_.width());
  lua_setfield(L, -2, "width");
  lua_pushinteger(L, graphics_.height());
  lua_setfield(L, -2, "height");
  lua_pushnumber(L, time);
  lua_setfield(L, -2, "time");
}

void Recipe::push_function(const char* name) {
  lua_State* L = state_.raw();
  lua_rawgeti(L, LUA_REGISTRYINDEX, table_);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

void Recipe::set_up() {
  lua_State* L = state_.raw();
  push_function("setup");
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
  } else {
    gl::Recorder* recorder = graphics_.recorder();
    graphics_.trace_into(nullptr);  // a trace is of the frame
    push_context(0);
    state_.restart_budget();
    state_.call(1, 0);
    graphics_.trace_into(recorder);
  }
  lua::end_setup(stage_);
  set_up_ = true;
}

void Recipe::draw(double time) {
  graphics_.context().make_current();
  lua::begin_frame(stage_);
  if (!set_up_) {
    set_up();
    lua::begin_frame(stage_);
  }
  passes_.clear();
  push_function("draw");
  push_context(time);
  state_.restart_budget();
  state_.call(1, 0);
}

void Recipe::begin_pass(const std::string& name) {
  passes_.push_back({name, 0});
  if (gl::Recorder* recorder = graphics_.recorder()) recorder->begin_pass(name);
  if (!time_passes_) return;
  graphics_.gl.Finish.unrecorded();
  pass_began_ = now();
}

void Recipe::end_pass() {
  if (time_passes_) {
    graphics_.gl.Finish.unrecorded();
    passes_.back().milliseconds = now() - pass_began_;
  }
  if (gl::Recorder* recorder = graphics_.recorder()) recorder->end_pass();
  if (pass_ended_) pass_ended_(passes_.size() - 1);
}

}  // namespace shadowlab::recipe
