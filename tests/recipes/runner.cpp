// lua_tests: runs tests written in Lua, of what users see.
//
//   lua_tests FILE.lua [FACT] [--keep DIR]    runs its tests, or the one; keeps pictures as PNG
//   lua_tests FILE.lua --list                 prints their names
//
// A file registers tests: test("fact_it_establishes", function() … end). They have all that recipes
// have (require looks beside the file, in the folder above it and in scripts/), and:
//
//   render(recipe, {size = {256, 256}, scene = , set = {light = "2,4,1"}, frames = 1, time = 0,
//                   visibility = false})
//     the picture of a recipe: NAME.lua in scripts/ or beside the test; with visibility the stock
//     shaders draw white where the light reaches and black where not
//   frame(width, height, function(r) … end)
//     the picture of a frame that the test draws itself, from GL's defaults, at most 512 × 512
//   expect(condition, words)
//   expect_equal(a, b, words)
//   expect_near(a, b, tolerance, reason)      numbers or vectors
//   expect_error(function, part of its sentence)
//
// picture.h says what a picture can be asked. Exit code 0: all hold; 1: one fails; 2: the file or
// the arguments are wrong; 3: there is no GL context.
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "core/error.h"
#include "core/near_names.h"
#include "core/version.h"
#include "expect.h"
#include "lua/boxes.h"
#include "render.h"

namespace shadowlab::tests {
namespace {

constexpr int largest = 512;

struct Test {
  std::string fact;
  int function;  ///< in Lua's registry
};

class TestFile : private lua::PassListener {
 public:
  explicit TestFile(std::filesystem::path file);

  const std::vector<Test>& tests() const { return tests_; }
  /// Throws InputError with the expectation that fails.
  void run(const Test& test);
  void keep_pictures_in(const std::filesystem::path& folder) { keep_ = folder; }

 private:
  static TestFile& of(lua_State* L) {
    return *static_cast<TestFile*>(lua_touserdata(L, lua_upvalueindex(1)));
  }
  static int register_test(lua_State* L);
  static int render_recipe(lua_State* L);
  static int draw_frame(lua_State* L);
  void begin_pass(std::string_view name) override { pass_ = name; }
  void end_pass() override;
  void set_global(const char* name, lua_CFunction function);
  std::filesystem::path find_recipe(const std::string& name) const;
  void give(Frame frame);

  std::filesystem::path file_;
  gl::Graphics graphics_;
  /// Contexts for render, by picture size: programs are compiled once for all tests of a file.
  std::map<std::pair<int, int>, std::unique_ptr<gl::Graphics>> others_;
  lua::State state_;
  lua::Stage stage_;
  std::vector<Test> tests_;
  std::string fact_;
  std::filesystem::path keep_;
  int kept_ = 0;
  // The frame that the test draws itself.
  bool drawing_ = false;
  int width_ = 0, height_ = 0;
  std::string pass_;
  Frame frame_;
};

TestFile::TestFile(std::filesystem::path file)
    : file_(file.has_parent_path() ? std::move(file) : "." / file),
      graphics_(context::create(), largest, largest),
      state_({}, [](std::string_view line) { fmt::print("{}", line); }),
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
  set_global("test", lua::guarded<register_test>);
  set_global("render", lua::guarded<render_recipe>);
  set_global("frame", lua::guarded<draw_frame>);
  state_.load_file(file_);
  state_.call(0, 0);
  if (tests_.empty()) throw InputError(file_.string() + ": there is no test in it");
}

void TestFile::set_global(const char* name, lua_CFunction function) {
  lua_State* L = state_.raw();
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, function, 1);
  lua_setglobal(L, name);
}

int TestFile::register_test(lua_State* L) {
  TestFile& self = of(L);
  if (lua_type(L, 1) != LUA_TSTRING || !lua_isfunction(L, 2))
    throw InputError("test takes the fact and a function: test(\"a_fact\", function() … end)");
  const std::string fact = lua_tostring(L, 1);
  for (const Test& other : self.tests_) {
    if (other.fact == fact) throw InputError(fmt::format("there are two tests {}", fact));
  }
  lua_settop(L, 2);
  self.tests_.push_back({fact, luaL_ref(L, LUA_REGISTRYINDEX)});
  return 0;
}

void TestFile::run(const Test& test) {
  fact_ = test.fact;
  kept_ = 0;
  graphics_.context().make_current();
  lua_rawgeti(state_.raw(), LUA_REGISTRYINDEX, test.function);
  state_.restart_budget();
  state_.call(0, 0);
}

void TestFile::give(Frame frame) {
  if (!keep_.empty()) {
    const std::string name = fmt::format("{}_{}.png", fact_, ++kept_);
    image::write_png(keep_ / name, frame.back().color);
  }
  push_picture(state_.raw(), std::move(frame));
}

// The recipe of that name in scripts/, or beside the tests.
std::filesystem::path TestFile::find_recipe(const std::string& name) const {
  std::filesystem::path file = home() / "scripts" / (name + ".lua");
  if (!std::filesystem::is_regular_file(file)) file = file_.parent_path() / (name + ".lua");
  return file.lexically_proximate(std::filesystem::current_path());
}

int TestFile::render_recipe(lua_State* L) {
  TestFile& self = of(L);
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

void TestFile::end_pass() {
  if (drawing_) frame_.push_back(look_at(graphics_.frame, width_, height_, pass_));
}

int TestFile::draw_frame(lua_State* L) {
  TestFile& self = of(L);
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

struct Arguments {
  std::string file;
  std::string fact;
  std::string keep;
  bool list = false;
};

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list") {
      arguments.list = true;
    } else if (word == "--keep" && i + 1 < argc) {
      arguments.keep = argv[++i];
    } else if (word.starts_with('-') || !arguments.fact.empty()) {
      throw InputError("lua_tests FILE.lua [FACT] [--keep DIR] [--list]; what is " + word + "?");
    } else {
      (arguments.file.empty() ? arguments.file : arguments.fact) = word;
    }
  }
  if (arguments.file.empty()) throw InputError("lua_tests takes a file of tests");
  return arguments;
}

int run_all(const Arguments& arguments) {
  TestFile file(arguments.file);
  if (!arguments.keep.empty()) {
    std::filesystem::create_directories(arguments.keep);
    file.keep_pictures_in(arguments.keep);
  }
  int ran = 0, failed = 0;
  std::vector<std::string_view> facts;
  for (const Test& test : file.tests()) {
    facts.push_back(test.fact);
    if (arguments.list) fmt::print("{}\n", test.fact);
    if (arguments.list || (!arguments.fact.empty() && test.fact != arguments.fact)) continue;
    ++ran;
    try {
      file.run(test);
      fmt::print("holds   {}\n", test.fact);
    } catch (const InputError& problem) {
      ++failed;
      fmt::print("FAILS   {}\n        {}\n", test.fact, problem.what());
    }
  }
  if (!arguments.list && ran == 0) {
    throw InputError(fmt::format("{} has no test {}{}", arguments.file, arguments.fact,
                                 did_you_mean(arguments.fact, facts)));
  }
  return failed == 0 ? 0 : 1;
}

int answer(int argc, char** argv) {
  try {
    return run_all(read_arguments(argc, argv));
  } catch (const MachineError& problem) {
    fmt::print(stderr, "lua_tests: {}\n", problem.what());
    return 3;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "lua_tests: {}\n", problem.what());
    return 2;
  }
}

}  // namespace
}  // namespace shadowlab::tests

int main(int argc, char** argv) { return shadowlab::tests::answer(argc, argv); }
