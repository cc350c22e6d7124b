// require: Lua modules in the folders of the state, and nothing else.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

namespace fs = std::filesystem;

// The registry's table of what each module returned.
constexpr const char* results_key = "shadowlab.modules";
constexpr std::size_t longest_module_name = 200;

bool is_module_name(std::string_view name) {
  if (name.empty() || name.size() > longest_module_name) return false;
  bool in_part = false;
  for (const char c : name) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (!letter && !(c == '.' && in_part)) return false;
    in_part = letter;
  }
  return in_part;
}

// Whether `file` is inside `folder` once all symbolic links are followed.
bool is_inside(const fs::path& file, const fs::path& folder) {
  std::error_code failure;
  const fs::path real_folder = fs::canonical(folder, failure);
  if (failure) return false;
  const fs::path real_file = fs::canonical(file, failure);
  if (failure) return false;
  return std::mismatch(real_folder.begin(), real_folder.end(), real_file.begin(), real_file.end())
             .first == real_folder.end();
}

fs::path find_module(const State& state, const std::string& name) {
  std::string relative = name;
  std::ranges::replace(relative, '.', '/');
  relative += ".lua";
  std::string looked;
  for (const fs::path& folder : state.search_folders()) {
    fs::path file = folder / relative;
    state.note_file(file);
    std::error_code failure;
    if (fs::is_regular_file(file, failure)) {
      if (is_inside(file, folder)) return file;
      throw InputError("require \"" + name + "\": " + file.string() +
                       " is a link that leads out of its folder");
    }
    looked += (looked.empty() ? " in " : " or ") + folder.string();
  }
  throw InputError("require \"" + name + "\": there is no " + relative + looked);
}

// Names the module as running while it lives.
class UnderWay {
 public:
  UnderWay(State& state, const std::string& name) : names_(state.modules_under_way()) {
    if (std::ranges::find(names_, name) != names_.end()) {
      std::string chain;
      for (const std::string& each : names_) chain += each + " -> ";
      throw InputError("require \"" + name + "\" goes round in a circle: " + chain + name);
    }
    names_.push_back(name);
  }
  ~UnderWay() { names_.pop_back(); }
  UnderWay(const UnderWay&) = delete;
  UnderWay& operator=(const UnderWay&) = delete;

 private:
  std::vector<std::string>& names_;
};

int require(lua_State* L) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(L, 1, &length);
  if (!is_module_name({text, length}))
    throw InputError(
        "require takes a module's name, such as \"scenes.room\": letters, digits and _"
        " in parts joined by dots");
  const std::string name(text, length);
  State& state = State::of(L);
  lua_settop(L, 1);
  lua_getfield(L, LUA_REGISTRYINDEX, results_key);
  if (lua_getfield(L, 2, name.c_str()) != LUA_TNIL) return 1;
  lua_pop(L, 1);

  const UnderWay under_way(state, name);
  const fs::path file = find_module(state, name);
  if (const auto problem = state.try_load_file(L, file)) {
    lua_pushlstring(L, problem->data(), problem->size());
    return lua_error(L);  // it begins with the module's own file and line
  }
  state.check_budget(0);
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  if (lua_isnil(L, -1)) {
    lua_pushboolean(L, 1);
    lua_replace(L, -2);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, 2, name.c_str());
  return 1;
}

}  // namespace

void add_require(lua_State* L) {
  lua_newtable(L);
  lua_setfield(L, LUA_REGISTRYINDEX, results_key);
  lua_pushcfunction(L, guarded<require>);
  lua_setglobal(L, "require");
}

}  // namespace shadowlab::lua
