// What a hostile script tries in plain Lua: each must end within a small budget, in one sentence.
#include "script.h"

namespace shadowlab::lua {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string end_of_memory = "the recipe needs more than 16 MiB of memory";
const std::string too_deep = "functions call each other too deeply (stack overflow)";

class Greedy : public testing::TestWithParam<Attack> {};

TEST_P(Greedy, ends_with_the_memory) {
  Script script([] {
    Limits limits = small_limits();
    limits.instructions = 100'000'000;
    limits.seconds = 20;
    return limits;
  }());
  EXPECT_THAT(script.error(GetParam().text), AllOf(StartsWith("a.lua:"), HasSubstr(end_of_memory)));
  EXPECT_LE(script.state().heap().bytes(), small_limits().memory);
  EXPECT_EQ(script.value("return 1 + 1"), "2");
}

INSTANTIATE_TEST_SUITE_P(
    Sandbox, Greedy,
    testing::Values(Attack{"table", "local t = {} for i = 1, 1e9 do t[i] = i end"},
                    Attack{"tables", "local t = {} while true do t = {t} end"},
                    Attack{"strings", "local s = 'x' while true do s = s .. s end"},
                    Attack{"concat",
                           "local t = {} for i = 1, 100 do t[i] = ('x'):rep(2^18) end\n"
                           "return table.concat(t)"},
                    Attack{"gsub", "return ('x'):rep(2^20):gsub('.', ('y'):rep(2^20))"},
                    Attack{"format",
                           "local s = ('x'):rep(2^22) return ('%s%s%s%s%s'):format(s, s, "
                           "s, s, s)"},
                    Attack{"coroutines",
                           "local t = {} while true do t = {t, coroutine.create(print)} end"},
                    Attack{"closures",
                           "local f while true do local g = f f = function() return g "
                           "end end"}),
    name_of);

class Deep : public testing::TestWithParam<Attack> {};

TEST_P(Deep, ends_with_a_plain_sentence) {
  Limits limits = small_limits();
  limits.memory = std::size_t{256} << 20;
  limits.instructions = 100'000'000;
  limits.seconds = 20;
  Script script(limits);
  EXPECT_THAT(script.error(GetParam().text), AllOf(StartsWith("a.lua:"), HasSubstr(too_deep)));
  EXPECT_EQ(script.value("return 1 + 1"), "2");
}

INSTANTIATE_TEST_SUITE_P(
    Sandbox, Deep,
    testing::Values(
        Attack{"recursion", "local function f() return 1 + f() end f()"},
        Attack{"gsub_callbacks", "local function f() return ('x'):gsub('x', f) end f()"},
        Attack{"sort_comparators", "local function f() table.sort({2, 1}, f) end f()"},
        Attack{
            "index_functions",
            "local t t = setmetatable({}, {__index = function(_, k) return t[k] end}) return t.x"},
        Attack{"tostring_functions",
               "local t t = setmetatable({}, {__tostring = function() return tostring(t) end}) "
               "return tostring(t)"},
        Attack{"coroutines", "local function f() coroutine.wrap(f)() end f()"},
        Attack{
            "pairs_functions",
            "local t t = setmetatable({}, {__pairs = function() return pairs(t) end}) pairs(t)"}),
    name_of);

TEST(Sandbox, time_ends_what_instructions_do_not) {
  Limits limits = small_limits();
  limits.instructions = ~std::uint64_t{0};
  limits.seconds = 0.1;
  EXPECT_EQ(Script(limits).error("while true do end"),
            "a.lua:1: the recipe ran for more than 0.1 seconds in one go; does a loop never end?");
}

TEST(Sandbox, deep_recursion_in_protected_calls_ends) {
  Limits limits = small_limits();
  limits.memory = std::size_t{512} << 20;
  limits.instructions = 1'000'000'000;
  limits.seconds = 20;
  Script script(limits);
  EXPECT_THAT(script.value("local deepest = 0\n"
                           "local function f(n) deepest = n return pcall(f, n + 1) end\n"
                           "f(1) return deepest > 100 and 'came back'"),
              "came back");
  EXPECT_EQ(script.value("local function f() return xpcall(f, f) end f() return 'came back'"),
            "came back");
  // Stock Lua 5.4.4 crashes here: each close begins to count its depth anew.
  EXPECT_EQ(script.value("local failed = false\n"
                         "local function close(t)\n"
                         "  if t.next and not coroutine.close(t.next) then failed = true end end\n"
                         "local last\n"
                         "for i = 1, 100000 do\n"
                         "  local m, t = {}, {next = last}\n"
                         "  setmetatable(t, m) m.__close = close\n"
                         "  last = coroutine.create(function() local x <close> = t "
                         "coroutine.yield() end)\n"
                         "  coroutine.resume(last)\n"
                         "end\n"
                         "coroutine.close(last) return failed"),
            "true");
}

TEST(Sandbox, a_range_that_no_table_holds_is_refused_at_once) {
  Script script;
  EXPECT_EQ(script.error("table.move({}, 1, 1 << 60, 2)"),
            "a.lua:1: table.move: there are too many places from 1 to 1152921504606846976");
  EXPECT_THAT(script.error("table.unpack({}, 1, 1 << 60)"), HasSubstr("too many places"));
  EXPECT_THAT(script.error("table.unpack({}, 1, 1e7)"),
              AnyOf(HasSubstr("too many"), HasSubstr(end_of_budget)));
  script.state().restart_budget();
  EXPECT_THAT(script.error("table.concat({}, '', 1, 1 << 60)"), HasSubstr("too many places"));
  EXPECT_THAT(script.error("table.concat({}, '', 1, 1 << 20)"), HasSubstr("at 1 is a nil"));
  EXPECT_EQ(script.value("local t = setmetatable({}, {__len = function() return 1 << 60 end}) "
                         "table.insert(t, 'x') return t[1]"),
            "x");
  EXPECT_EQ(script.value("return (string.rep('', 1 << 60))"), "");
  EXPECT_THAT(script.error("return string.rep('x', 1 << 60)"), HasSubstr("string.rep"));
  EXPECT_THAT(script.error("return string.rep('x', 1 << 33, ',')"), HasSubstr("string.rep"));
}

TEST(Sandbox, finalizers_are_refused) {
  Script script;
  EXPECT_EQ(script.error("setmetatable({}, {__gc = function() while true do end end})"),
            "a.lua:1: setmetatable: __gc is not available in a recipe");
  EXPECT_EQ(script.error("setmetatable({}, {__close = print})"),
            "a.lua:1: setmetatable: __close is not available in a recipe");
  // Set later, Lua does not look at it.
  EXPECT_EQ(script.value("local m = {} local t = setmetatable({}, m) m.__gc = function() escaped = "
                         "true end t = nil"),
            "nil");
  lua_gc(script.raw(), LUA_GCCOLLECT);
  EXPECT_FALSE(script.escaped());
}

TEST(Sandbox, what_leads_out_is_not_there) {
  Script script;
  EXPECT_EQ(script.value("local names = {} for name in pairs(_G) do names[#names + 1] = name end "
                         "return table.concat(names, ' ')"),
            "_G _VERSION assert coroutine error getmetatable ipairs math next pairs pcall print "
            "rawequal rawget rawlen rawset require select setmetatable string table tonumber "
            "tostring type utf8 xpcall");
  for (const std::string name :
       {"load", "loadstring", "loadfile", "dofile", "collectgarbage", "debug", "io", "os",
        "package", "string.dump", "string.pack", "string.unpack", "string.packsize"})
    EXPECT_EQ(script.error("return " + name), "a.lua:1: " + name + " is not available in a recipe");
  EXPECT_THAT(script.error("return ('x').dump"), HasSubstr("string.dump is not available"));
}

TEST(Sandbox, locked_metatables_stay_closed) {
  Script script;
  EXPECT_EQ(script.value("return getmetatable('')"), "false");
  EXPECT_EQ(script.value("return getmetatable(_G)"), "false");
  EXPECT_EQ(script.value("return getmetatable(string)"), "false");
  EXPECT_THAT(script.error("return getmetatable('').__index"), HasSubstr("index a boolean"));
  EXPECT_EQ(script.error("setmetatable(_G, nil)"),
            "a.lua:1: setmetatable: this table's metatable is locked");
  EXPECT_THAT(script.error("setmetatable('', {})"), HasSubstr("table expected"));
  EXPECT_EQ(script.value("return getmetatable(setmetatable({}, {__metatable = 'mine'}))"), "mine");
}

TEST(Sandbox, environment_games_reach_nothing_more) {
  Script script;
  EXPECT_THAT(script.error("local _ENV = {} return print.x"), HasSubstr("global 'print'"));
  EXPECT_EQ(script.value("local _ENV = setmetatable({}, {__index = _G}) return tostring(1)"), "1");
  EXPECT_THAT(script.error("local _ENV = setmetatable({}, {__index = _G}) return os"),
              HasSubstr("os is not available"));
  EXPECT_EQ(script.value("return rawget(_G, 'os')"), "nil");
  EXPECT_THAT(script.error("local _ENV <const> = 1; print(X)"), StartsWith("a.lua:1: "));
}

TEST(Sandbox, no_text_shows_an_address) {
  Script script;
  for (const std::string value : {"{}", "print", "function() end", "coroutine.create(print)",
                                  "setmetatable({}, {__name = 'Thing'})", "pairs({})"})
    for (const std::string& text : {"tostring(" + value + ")", "('%s'):format(" + value + ")",
                                    "select(2, pcall(error, tostring(" + value + ")))"})
      EXPECT_THAT(script.value("return (" + text + ")"),
                  AnyOf("table", "function", "thread", "Thing"))
          << text;
  EXPECT_THAT(script.error("return ('%p'):format({})"), HasSubstr("'%p' is no directive"));
}

TEST(Sandbox, a_coroutine_stopped_by_the_budget_is_dead_for_the_next) {
  Script script;
  EXPECT_THAT(script.error("local m = {} local t = setmetatable({}, m)\n"
                           "m.__close = function() escaped = true while true do end end\n"
                           "co = coroutine.create(function() local x <close> = t while true do end "
                           "end) coroutine.resume(co)"),
              HasSubstr(end_of_budget));
  script.state().restart_budget();
  EXPECT_EQ(script.value("return coroutine.status(co)"), "dead");
  EXPECT_EQ(script.value("return coroutine.close(co)"), "false");
  EXPECT_FALSE(script.escaped());
}

TEST(Sandbox, an_interrupted_parent_of_a_coroutine_does_not_go_on) {
  Script script;
  EXPECT_THAT(script.error("local m = {} local t = setmetatable({}, m)\n"
                           "m.__close = function() escaped = true end\n"
                           "local x <close> = t\n"
                           "coroutine.wrap(function() while true do end end)()"),
              HasSubstr(end_of_budget));
  EXPECT_FALSE(script.escaped());
}

TEST(Sandbox, a_huge_or_hostile_error_is_a_short_sentence) {
  Script script;
  EXPECT_LE(script.error("error(('x'):rep(2^22))").size(), 1000u);
  EXPECT_LE(script.error("_G[('x'):rep(2^20)]()").size(), 1000u);
  EXPECT_LE(script.error("return _G[('x'):rep(2^20)]").size(), 1000u);
  EXPECT_EQ(script.error("error(setmetatable({}, {__tostring = function() return {} end}))"),
            "a.lua:1: the error's own __tostring failed");
  EXPECT_EQ(script.error("error(setmetatable({}, {__tostring = error}))"),
            "a.lua:1: the error's own __tostring failed");
  EXPECT_EQ(script.error("error(coroutine.create(print))"),
            "a.lua:1: error was called with a thread instead of a message");
}

}  // namespace
}  // namespace shadowlab::lua
