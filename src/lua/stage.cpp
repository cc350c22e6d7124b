#include "lua/stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "lua/planned.h"
#include "lua/truth_pool.h"
#include "lua/value.h"
#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t most_explanations = 1000;

const char key = 0;  // its address is where the registry keeps the stage

// Whether `file` is in `folder` once symbolic links are followed.
bool inside(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code error;
  const auto real = std::filesystem::canonical(file, error);
  if (error) return false;
  const auto root = std::filesystem::canonical(folder, error);
  if (error) return false;
  const auto [end, ignored] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
  return end == root.end();
}

}  // namespace

Stage& Stage::of(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &key);
  auto* stage = static_cast<Stage*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  return *stage;
}

void Stage::install(lua_State* L, Stage& stage) {
  lua_pushlightuserdata(L, &stage);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &key);
}

void Stage::explain(std::string text) {
  const auto same = [&](const Explanation& known) { return known.text == text; };
  if (!explaining || explanations.size() >= most_explanations ||
      std::any_of(explanations.begin(), explanations.end(), same))
    return;
  explanations.push_back({pass_name, std::move(text)});
}

std::filesystem::path find_file(const Stage& stage, const std::string& name) {
  const std::filesystem::path path(name);
  if (name.empty() || path.is_absolute()) {
    throw InputError(
        fmt::format("a file is named relative to the recipe's folder; \"{}\" is not", name));
  }
  for (const auto& folder : stage.folders) {
    std::error_code error;
    auto file = folder / path;
    stage.state.note_file(file);
    if (!std::filesystem::is_regular_file(file, error)) continue;
    if (!inside(file, folder)) {
      throw InputError(fmt::format("\"{}\" leads out of the recipe's folder", name));
    }
    return file;
  }
  throw InputError(
      fmt::format("there is no file \"{}\" beside the recipe or in shadowlab's folders", name));
}

void begin_frame(Stage& stage) {
  stage.graphics.begin_frame();
  stage.volumes->begin_frame();
  stage.truths->begin_frame();
  if (stage.planned) stage.planned->begin_frame();
  stage.explanations.resize(stage.explained_in_setup);
}

void end_setup(Stage& stage) {
  stage.graphics.keep_uniforms();
  stage.volumes->keep_all();
  stage.explained_in_setup = stage.explanations.size();
}

void open_all(Stage& stage) {
  Stage::install(stage.state.raw(), stage);
  open_values(stage.state.raw());
  open_gl(stage);
  open_shader(stage);
  open_mesh(stage);
  open_scene(stage);
  open_shadow(stage);
  open_fbo(stage);
  open_pass(stage);
  open_param(stage);
}

}  // namespace shadowlab::lua
