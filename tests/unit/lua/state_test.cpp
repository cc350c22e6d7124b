#include "lua/state.h"

#include <filesystem>
#include <fstream>

#include "lua/guard.h"
#include "script.h"

namespace shadowlab::lua {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class Folder {
 public:
  Folder() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = fs::temp_directory_path() / (std::string("shadowlab_") + test->name());
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path path() const { return path_; }
  fs::path write(const std::string& name, std::string_view text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  fs::path path_;
};

int refuse_radius(lua_State*) { throw InputError("the radius is negative"); }

std::string load_error(Script& script, const fs::path& path) {
  try {
    script.state().load_file(path);
    return "no error";
  } catch (const InputError& problem) {
    return problem.what();
  }
}

TEST(State, two_live_side_by_side) {
  Script one, other;
  one.value("x = 1");
  EXPECT_EQ(one.value("return x"), "1");
  EXPECT_EQ(other.value("return rawget(_G, 'x')"), "nil");
}

TEST(State, an_error_begins_with_file_and_line) {
  Script script;
  EXPECT_EQ(script.error("\nlocal t = nil\nt.x = 1"),
            "a.lua:3: attempt to index a nil value (local 't')");
  EXPECT_EQ(script.error("\nlocal x = = 1"), "a.lua:2: unexpected symbol near '='");
  EXPECT_EQ(script.error("\n\nerror('no position', 0)"), "a.lua:3: no position");
  EXPECT_EQ(script.error("error()"), "a.lua:1: error was called without a message");
  EXPECT_EQ(script.error("error({})"),
            "a.lua:1: error was called with a table instead of a message");
  EXPECT_EQ(script.error("error(setmetatable({}, {__tostring = function() return 'mine' end}))"),
            "a.lua:1: mine");
  EXPECT_EQ(script.error("coroutine.wrap(function()\nerror('inside') end)()"), "a.lua:2: inside");
}

TEST(State, an_error_says_its_place_behind_the_line) {
  Script script;
  script.state().set_place([] { return std::string("in pass \"2. the shadow\""); });
  EXPECT_EQ(script.error("\nerror 'wrong'"), "a.lua:2: in pass \"2. the shadow\": wrong");
  EXPECT_EQ(script.error("while true do end"),
            "a.lua:1: in pass \"2. the shadow\": the recipe ran more than 1000000 instructions in "
            "one go; does a loop never end?");
}

TEST(State, the_place_is_asked_for_while_the_failing_function_runs) {
  Script script;
  std::string depth = "outside";
  script.state().set_place([&] { return depth; });
  lua_pushlightuserdata(script.raw(), &depth);
  lua_pushcclosure(
      script.raw(),
      [](lua_State* L) {
        struct Inside {
          std::string& depth;
          explicit Inside(std::string& text) : depth(text) { depth = "inside"; }
          ~Inside() { depth = "outside"; }
        } const inside(*static_cast<std::string*>(lua_touserdata(L, lua_upvalueindex(1))));
        lua_call(L, 0, 0);
        return 0;
      },
      1);
  lua_setglobal(script.raw(), "within");
  EXPECT_EQ(script.error("within(function() error('wrong') end)"), "a.lua:1: inside: wrong");
  EXPECT_EQ(depth, "outside");
}

TEST(State, a_binding_that_throws_is_an_error_of_the_calling_line) {
  Script script;
  lua_pushcfunction(script.raw(), guarded<refuse_radius>);
  lua_setglobal(script.raw(), "sphere");
  EXPECT_EQ(script.error("\nsphere()"), "a.lua:2: the radius is negative");
  EXPECT_EQ(script.value("return select(2, pcall(function() sphere() end))"),
            "a.lua:1: the radius is negative");
}

TEST(State, a_long_path_is_named_in_full) {
  Script script;
  const std::string path = "/home/student/" + std::string(100, 'x') + "/recipe.lua";
  for (const std::string text : {"error 'wrong'", "x = = 1"}) {
    try {
      script.state().load_text(text, path);
      script.state().call(0, 0);
      FAIL();
    } catch (const InputError& problem) {
      EXPECT_THAT(problem.what(), StartsWith(path + ":1: "));
    }
  }
}

TEST(State, a_message_is_one_line_of_at_most_a_thousand_characters) {
  Script script;
  const std::string sentence = script.error("error(('long\\n'):rep(100000))");
  EXPECT_EQ(sentence.size(), 1000u);
  EXPECT_THAT(sentence, StartsWith("a.lua:1: long long "));
}

TEST(State, byte_order_mark_and_first_line_of_a_unix_script_are_skipped) {
  Script script;
  EXPECT_EQ(script.value("\xEF\xBB\xBF#!/usr/bin/env shadowlab\nreturn 7"), "7");
  EXPECT_EQ(script.error("#!x\nerror 'second'"), "a.lua:2: second");
  EXPECT_EQ(script.value("#"), "nil");
}

TEST(State, a_file_that_is_no_script_is_refused_with_its_path) {
  const Folder folder;
  Script script;
  const std::string there = folder.path().string();
  EXPECT_EQ(load_error(script, folder.path() / "no.lua"), there + "/no.lua: there is no such file");
  EXPECT_EQ(load_error(script, folder.path()), there + ": this is a folder, not a script");
  EXPECT_EQ(load_error(script, "/dev/zero"), "/dev/zero: this is not a plain file");
  folder.write("big.lua", std::string((std::size_t{1} << 20) + 1, ' '));
  EXPECT_EQ(load_error(script, folder.path() / "big.lua"),
            there + "/big.lua: the file is larger than 1 MiB, too large for a script");
  folder.write("code.lua", "\x1bLua");
  EXPECT_EQ(load_error(script, folder.path() / "code.lua"),
            there + "/code.lua: this is compiled Lua; give the text of the script instead");
  EXPECT_EQ(load_error(script, folder.write("good.lua", "return 1")), "no error");
}

TEST(State, what_is_printed_is_joined_by_tabs_and_ends_with_one_notice) {
  Script script;
  script.value("print(1, 2.0, 'x', nil, true, {}, print, coroutine.create(print))");
  EXPECT_EQ(script.printed(), "1\t2.0\tx\tnil\ttrue\ttable\tfunction\tthread\n");
  Script flood;
  flood.value("for i = 1, 1000 do print('0123456789') end");
  EXPECT_EQ(flood.printed().size(),
            90 * 11 + std::string("... the recipe printed more than 1000 bytes; the rest is not "
                                  "shown\n")
                          .size());
}

TEST(State, a_new_budget_lets_a_stopped_script_go_on) {
  Script script;
  EXPECT_THAT(script.error("while true do end"), HasSubstr("1000000 instructions"));
  EXPECT_THAT(script.error("return 1"), HasSubstr("1000000 instructions"));
  script.state().restart_budget();
  EXPECT_EQ(script.value("return 1"), "1");
}

TEST(State, native_work_is_paid_from_the_budget) {
  Script script;
  script.state().check_budget(999'000);
  EXPECT_THROW(script.state().check_budget(2'000), InputError);
  EXPECT_TRUE(script.state().exhausted());
}

TEST(State, memory_outside_lua_counts) {
  Script script;
  script.state().reserve(std::size_t{15} << 20);
  EXPECT_THROW(script.state().reserve(std::size_t{2} << 20), InputError);
  script.state().release(std::size_t{15} << 20);
  EXPECT_NO_THROW(script.state().reserve(std::size_t{2} << 20));
  script.state().release(std::size_t{2} << 20);
}

TEST(State, each_allocation_may_fail) {
  const std::string_view text =
      "local t = {} for i = 1, 20 do t[i] = ('x'):rep(i) .. i end\n"
      "local co = coroutine.wrap(function(...) coroutine.yield(table.pack(...)) end)\n"
      "for k, v in pairs(co(1, 2, 3)) do t[k] = v end\n"
      "table.sort(t, function(a, b) return tostring(a) < tostring(b) end)\n"
      "return #table.concat(t, ', '):gsub('%d', function(d) return d + 1 end)";
  std::uint64_t k = 1;
  for (bool failed = true; failed; ++k) {
    Script script;
    script.state().heap().fail_from(k);
    try {
      script.value(text);
      failed = false;
    } catch (const std::exception& problem) {
      EXPECT_THAT(problem.what(), HasSubstr("memory"));
    }
    script.state().heap().fail_from(0);
    EXPECT_EQ(script.value("return 1 + 1"), "2") << "after allocation " << k;
    ASSERT_LT(k, 10'000u);
  }
  EXPECT_GT(k, 50u);
}

// make(): garbage with a finalizer that counts in the integer behind the upvalue.
int make_counted(lua_State* L) {
  lua_newuserdatauv(L, 1, 0);
  lua_createtable(L, 0, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushcclosure(
      L,
      [](lua_State* thread) {
        ++*static_cast<int*>(lua_touserdata(thread, lua_upvalueindex(1)));
        return 0;
      },
      1);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
  return 0;
}

int collect_without_memory(lua_State* L) {
  Heap& heap = State::of(L).heap();
  heap.fail_from(1);
  lua_gc(L, LUA_GCCOLLECT);
  heap.fail_from(0);
  return 0;
}

TEST(State, finalizers_run_where_no_other_allocation_is_granted) {
  Script script;
  int finalized = 0;
  lua_pushlightuserdata(script.raw(), &finalized);
  lua_pushcclosure(script.raw(), make_counted, 1);
  lua_setglobal(script.raw(), "make");
  lua_pushcfunction(script.raw(), collect_without_memory);
  lua_setglobal(script.raw(), "collect");
  // Each level is deeper than any before: the frame of its finalizers has yet to be allocated.
  script.value(
      "local function deeper(n) make() collect() if n > 1 then return 1 + deeper(n - 1) end return "
      "1 end return deeper(150)");
  EXPECT_EQ(finalized, 150);
}

TEST(State, nothing_stays_allocated_after_a_state) {
  // The address sanitizer proves it; here the heap's own count.
  Script script;
  script.value("x = {} for i = 1, 1000 do x[i] = {i} end");
  const std::size_t full = script.state().heap().bytes();
  script.value("x = nil");
  lua_gc(script.raw(), LUA_GCCOLLECT);
  EXPECT_LT(script.state().heap().bytes(), full);
}

TEST(Require, finds_modules_in_the_folders_in_order_and_runs_each_once) {
  const Folder folder;
  folder.write("first/a.lua", "runs = (rawget(_G, 'runs') or 0) + 1 return {from = 'first'}");
  folder.write("second/a.lua", "return {from = 'second'}");
  folder.write("second/scenes/room.lua", "return {name = ...}");
  folder.write("second/nothing.lua", "");
  Script script;
  script.state().search_in({folder.path() / "first", folder.path() / "second"});
  EXPECT_EQ(script.value("return require('a').from"), "first");
  EXPECT_EQ(script.value("return require('a') == require('a')"), "true");
  EXPECT_EQ(script.value("return runs"), "1");
  EXPECT_EQ(script.value("return require('scenes.room').name"), "scenes.room");
  EXPECT_EQ(script.value("return require('nothing')"), "true");
  EXPECT_EQ(script.value("local co = coroutine.wrap(function() return require('scenes.room') end) "
                         "return co().name"),
            "scenes.room");
}

TEST(Require, an_error_in_a_module_names_the_module) {
  const Folder folder;
  folder.write("syntax.lua", "\nx = = 1");
  folder.write("fails.lua", "\n\nerror 'no light'");
  Script script;
  script.state().search_in({folder.path()});
  EXPECT_EQ(script.error("require 'syntax'"),
            (folder.path() / "syntax.lua").string() + ":2: unexpected symbol near '='");
  EXPECT_EQ(script.error("require 'fails'"),
            (folder.path() / "fails.lua").string() + ":3: no light");
  EXPECT_EQ(script.error("require 'missing.part'"),
            "a.lua:1: require \"missing.part\": there is no missing/part.lua in " +
                folder.path().string());
}

TEST(Require, a_circle_is_one_clear_error) {
  const Folder folder;
  folder.write("a.lua", "return require 'b'");
  folder.write("b.lua", "return require 'a'");
  Script script;
  script.state().search_in({folder.path()});
  EXPECT_EQ(
      script.error("require 'a'"),
      (folder.path() / "b.lua").string() + ":1: require \"a\" goes round in a circle: a -> b -> a");
  EXPECT_EQ(script.value("return pcall(require, 'a')"), "false");
}

TEST(Require, nothing_outside_the_folders_can_be_reached) {
  const Folder folder;
  folder.write("secret.lua", "return 'secret'");
  folder.write("inside/a.lua", "return 'a'");
  fs::create_symlink(folder.path() / "secret.lua", folder.path() / "inside/link.lua");
  fs::create_directory_symlink(folder.path(), folder.path() / "inside/up");
  fs::create_symlink(folder.path() / "inside/a.lua", folder.path() / "inside/same.lua");
  Script script;
  script.state().search_in({folder.path() / "inside"});
  EXPECT_EQ(script.value("return require 'same'"), "a");
  for (const std::string name : {"link", "up.secret"})
    EXPECT_THAT(script.error("require '" + name + "'"),
                HasSubstr("is a link that leads out of its folder"));
  for (const std::string name : {"../secret", "..secret", "/etc/passwd", "a/b", "", ".", "a.", ".a",
                                 "a..b", "a\\0b", "a b", "~root", "C:x"})
    EXPECT_THAT(script.error("require '" + name + "'"), HasSubstr("takes a module's name")) << name;
  for (const std::string name : {"io", "os", "string", "debug", "package", "_G"})
    EXPECT_THAT(script.error("require '" + name + "'"), HasSubstr("there is no " + name + ".lua"));
}

}  // namespace
}  // namespace shadowlab::lua
