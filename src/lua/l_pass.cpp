// pass(name, fn): a named step, which can be captured, timed, stepped through and traced.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_sentence = 1000;

// The pass that runs, for as long as it does, whichever way it ends.
class Running {
 public:
  Running(Stage& stage, std::string_view name) : stage_(stage) { stage_.pass_name = name; }
  ~Running() { stage_.pass_name.clear(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  Stage& stage_;
};

int run(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING || !lua_isfunction(L, 2)) {
    throw InputError(
        "pass takes a name and a function: pass(\"1. the receiver\", function() … end)");
  }
  std::size_t length = 0;
  const char* text = lua_tolstring(L, 1, &length);
  const std::string_view name(text, std::min(length, longest_name));
  Stage& stage = Stage::of(L);
  if (!stage.pass_name.empty()) {
    throw InputError(fmt::format("pass \"{}\" begins inside pass \"{}\"; passes follow one another",
                                 name, stage.pass_name));
  }
  stage.state.check_budget(1000);
  if (stage.passes) stage.passes->begin_pass(name);
  {
    const Running running(stage, name.empty() ? " " : name);
    lua_settop(L, 2);
    lua_call(L, 0, 0);
  }
  if (stage.passes) stage.passes->end_pass();
  return 0;
}

int explain(lua_State* L) {
  if (lua_gettop(L) != 1 || lua_type(L, 1) != LUA_TSTRING)
    throw InputError("explain takes a sentence: explain(\"the light is above the table\")");
  Stage& stage = Stage::of(L);
  if (!stage.explaining) return 0;
  std::size_t length = 0;
  const char* text = lua_tolstring(L, 1, &length);
  stage.state.check_budget(1000);
  stage.explain(std::string(text, std::min(length, longest_sentence)));
  return 0;
}

constexpr Entry functions[] = {
    {"pass", "pass(name, function)",
     "Runs the function as a named step of the frame. Passes do not nest.", guarded<run>},
    {"explain", "explain(sentence)",
     "Says why the recipe does what it does: `shadowlab run --explain` prints it below the pass. "
     "What was said before in a frame is not said again.",
     guarded<explain>},
};

}  // namespace

std::span<const Entry> pass_functions() { return functions; }

void open_pass(Stage& stage) {
  lua_State* L = stage.state.raw();
  lua_pushcfunction(L, guarded<run>);
  lua_setglobal(L, "pass");
  lua_pushcfunction(L, guarded<explain>);
  lua_setglobal(L, "explain");
  stage.state.set_place([&stage] {
    return stage.pass_name.empty() ? std::string() : fmt::format("in pass \"{}\"", stage.pass_name);
  });
}

}  // namespace shadowlab::lua
