#include "measure/fact_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/version.h"
#include "lua/boxes.h"
#include "measure/fact_expect.h"
#include "measure/fact_render.h"

namespace shadowlab::measure {
namespace {

constexpr int largest = 512;

std::string text_field(lua_State* L, const char* name) {
  lua_getfield(L, 1, name);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

Note read_note(lua_State* L) {
  Note note{luaL_checkstring(L, 1), {}};
  if (!lua_isnoneornil(L, 2))
    note.picture = lua::read_box<Picture>(L, 2, "the picture of a note").snapshot().color;
  return note;
}

}  // namespace

FactFile::FactFile(std::filesystem::path file, lua::PrintSink print)
    : file_(file.has_parent_path() ? std::move(file) : "." / file),
      graphics_(context::create(), largest, largest),
      state_({}, std::move(print)),
      stage_{state_,
             graphics_,
             this,
             {},
             {file_.parent_path(), home() / "scripts", home() / "shaders"}} {
  graphics_.begin_frame();
  state_.search_in({file_.parent_path(), file_.parent_path() / "..", home() / "scripts"});
  lua::open_all(stage_);
  lua_State* L = state_.raw();
  open_picture(L);
  open_expect(L);
  set_global("test", lua::guarded<register_fact>);
  set_global("row", lua::guarded<register_case>);
  set_global("naive", lua::guarded<note_naive>);
  set_global("ours", lua::guarded<note_ours>);
  set_global("render", lua::guarded<render_recipe>);
  set_global("frame", lua::guarded<draw_frame>);
  state_.load_file(file_);
  state_.call(0, 0);
  if (facts_.empty()) throw InputError(file_.string() + ": there is no test in it");
  check_cases();
}

void FactFile::set_global(const char* name, lua_CFunction function) {
  lua_State* L = state_.raw();
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, function, 1);
  lua_setglobal(L, name);
}

int FactFile::register_fact(lua_State* L) {
  FactFile& self = of(L);
  if (lua_type(L, 1) != LUA_TSTRING || !lua_isfunction(L, 2))
    throw InputError("test takes the fact and a function: test(\"a_fact\", function() … end)");
  const std::string fact = lua_tostring(L, 1);
  for (const Fact& other : self.facts_) {
    if (other.name == fact) throw InputError(fmt::format("there are two tests {}", fact));
  }
  lua_settop(L, 2);
  self.facts_.push_back({fact, luaL_ref(L, LUA_REGISTRYINDEX)});
  return 0;
}

void FactFile::run(const Fact& fact) {
  fact_ = fact.name;
  kept_ = 0;
  naive_.clear();
  ours_.clear();
  graphics_.context().make_current();
  lua_rawgeti(state_.raw(), LUA_REGISTRYINDEX, fact.function);
  state_.restart_budget();
  state_.call(0, 0);
}

void FactFile::give(Frame frame) {
  if (!keep_.empty()) {
    const std::string name = fmt::format("{}_{}.png", fact_, ++kept_);
    image::write_png(keep_ / name, frame.back().color);
  }
  push_picture(state_.raw(), std::move(frame));
}

// The recipe of that name in scripts/, or beside the tests.
std::filesystem::path FactFile::find_recipe(const std::string& name) const {
  std::filesystem::path file = home() / "scripts" / (name + ".lua");
  if (!std::filesystem::is_regular_file(file)) file = file_.parent_path() / (name + ".lua");
  return file.lexically_proximate(std::filesystem::current_path());
}

int FactFile::render_recipe(lua_State* L) {
  FactFile& self = of(L);
  const auto file = self.find_recipe(luaL_checkstring(L, 1));
  const RenderOptions options = read_render_options(L, 2);
  auto& graphics = self.others_[{options.width, options.height}];
  // The test's own context is current again however this ends.
  struct Restore {
    const gl::Graphics& own;
    ~Restore() { own.context().make_current(); }
  } const restore{self.graphics_};
  if (!graphics)
    graphics = std::make_unique<gl::Graphics>(context::create(), options.width, options.height);
  self.give(render(*graphics, file, options));
  return 1;
}

void FactFile::end_pass() {
  if (drawing_) frame_.push_back(look_at(graphics_.frame, width_, height_, pass_));
}

int FactFile::draw_frame(lua_State* L) {
  FactFile& self = of(L);
  const auto width = luaL_checkinteger(L, 1), height = luaL_checkinteger(L, 2);
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw InputError(fmt::format("frame is at most {} × {}", largest, largest));
  if (!lua_isfunction(L, 3)) throw InputError("frame takes width, height and a function");
  if (self.drawing_) throw InputError("a frame begins inside a frame");
  self.width_ = static_cast<int>(width);
  self.height_ = static_cast<int>(height);
  self.frame_.clear();
  self.stage_.corner = {self.width_, self.height_};
  lua::begin_frame(self.stage_);
  self.graphics_.gl.Viewport(0, 0, self.width_, self.height_);
  struct Drawing {
    bool& on;
    ~Drawing() { on = false; }
  } const drawing{self.drawing_ = true};
  lua_settop(L, 3);
  lua_newtable(L);
  lua_pushinteger(L, width);
  lua_setfield(L, -2, "width");
  lua_pushinteger(L, height);
  lua_setfield(L, -2, "height");
  lua_call(L, 1, 0);
  self.frame_.push_back(look_at(self.graphics_.frame, self.width_, self.height_, ""));
  self.give(std::move(self.frame_));
  return 1;
}

int FactFile::register_case(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  HardCase hard{0, text_field(L, "title"), text_field(L, "expected"), {}, text_field(L, "without")};
  lua_getfield(L, 1, "case");
  hard.number = static_cast<int>(lua_tointeger(L, -1));
  if (hard.number < 1 || hard.title.empty() || hard.expected.empty())
    throw InputError("row takes case, title, expected and facts");
  lua_getfield(L, 1, "facts");
  luaL_checktype(L, -1, LUA_TTABLE);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TSTRING; ++i) {
    hard.facts.emplace_back(lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  of(L).cases_.push_back(std::move(hard));
  return 0;
}

void FactFile::check_cases() const {
  for (const HardCase& hard : cases_) {
    if (hard.facts.empty())
      throw InputError(fmt::format("{}: row {} has no facts", file_.string(), hard.number));
    for (const std::string& name : hard.facts) {
      if (std::none_of(facts_.begin(), facts_.end(),
                       [&](const Fact& fact) { return fact.name == name; })) {
        throw InputError(
            fmt::format("{}: row {}: there is no test {}", file_.string(), hard.number, name));
      }
    }
  }
}

int FactFile::note_naive(lua_State* L) {
  of(L).naive_.push_back(read_note(L));
  return 0;
}

int FactFile::note_ours(lua_State* L) {
  of(L).ours_.push_back(read_note(L));
  return 0;
}

}  // namespace shadowlab::measure
