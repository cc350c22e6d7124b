// Files of facts in Lua: what tests/hard and tests/recipes are made of, and `shadowlab stress`
// shows.
//
// A file registers facts: test("fact_it_establishes", function() … end). They have all that recipes
// have (require looks beside the file, in the folder above it and in scripts/), and:
//
//   render(recipe, {size = {256, 256}, scene = , set = {light = "2,4,1"}, frames = 1, time = 0,
//                   visibility = false})
//     the picture of a recipe: NAME.lua in scripts/ or beside the file; with visibility the stock
//     shaders draw white where the light reaches and black where not
//   frame(width, height, function(r) … end)
//     the picture of a frame that the fact draws itself, from GL's defaults, at most 512 × 512
//   expect(condition, words)
//   expect_equal(a, b, words)
//   expect_near(a, b, tolerance, reason)      numbers or vectors
//   expect_error(function, part of its sentence)
//   naive(words, picture)    what the listing as a lecture prints it gives, for the row of the
//   case; ours(words, picture)     what shadowlab gives. A picture may be left out, but of a row
//   whose listing fails one of each is shown.
//
// and it may register rows, each of which sums facts up as one case:
//
//   row{ case = 3, title = "…", expected = "…", facts = { "fact_it_establishes", … },
//        without = "why the listing does not fail here" }
//
// fact_picture.h says what a picture can be asked.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/graphics.h"
#include "lua/stage.h"
#include "lua/state.h"
#include "measure/fact_picture.h"

namespace shadowlab::measure {

struct Fact {
  std::string name;
  int function;  ///< in Lua's registry
};

/// A hard case: what is exact, and the facts that hold it.
struct HardCase {
  int number = 0;
  std::string title;
  std::string expected;
  std::vector<std::string> facts;  ///< all in the same file
  std::string without;             ///< why no listing fails here; empty where one does
};

/// What a fact tells of one of the two.
struct Note {
  std::string words;
  std::optional<image::Image> picture;
};

class FactFile : private lua::PassListener {
 public:
  /// Runs the file, not its facts; what it prints goes to `print`. Throws InputError for what is
  /// wrong with it.
  explicit FactFile(
      std::filesystem::path file, lua::PrintSink print = [](std::string_view) {});

  const std::vector<Fact>& facts() const { return facts_; }
  const std::vector<HardCase>& cases() const { return cases_; }
  /// Throws InputError with the expectation that fails.
  void run(const Fact& fact);
  /// What the fact that ran last told, in its order.
  const std::vector<Note>& naive() const { return naive_; }
  const std::vector<Note>& ours() const { return ours_; }

  /// Every picture of every fact as a PNG in `folder`.
  void keep_pictures_in(const std::filesystem::path& folder) { keep_ = folder; }

 private:
  static FactFile& of(lua_State* L) {
    return *static_cast<FactFile*>(lua_touserdata(L, lua_upvalueindex(1)));
  }
  static int register_fact(lua_State* L);
  static int register_case(lua_State* L);
  static int render_recipe(lua_State* L);
  static int draw_frame(lua_State* L);
  static int note_naive(lua_State* L);
  static int note_ours(lua_State* L);
  void begin_pass(std::string_view name) override { pass_ = name; }
  void end_pass() override;
  void set_global(const char* name, lua_CFunction function);
  void check_cases() const;
  std::filesystem::path find_recipe(const std::string& name) const;
  void give(Frame frame);

  std::filesystem::path file_;
  gl::Graphics graphics_;
  /// Contexts for render, by picture size: programs are compiled once for all facts of a file.
  std::map<std::pair<int, int>, std::unique_ptr<gl::Graphics>> others_;
  lua::State state_;
  lua::Stage stage_;
  std::vector<Fact> facts_;
  std::vector<HardCase> cases_;
  std::vector<Note> naive_, ours_;
  std::string fact_;
  std::filesystem::path keep_;
  int kept_ = 0;
  // The frame that the fact draws itself.
  bool drawing_ = false;
  int width_ = 0, height_ = 0;
  std::string pass_;
  Frame frame_;
};

}  // namespace shadowlab::measure
