// What a hostile script tries in plain Lua: each must end within a small budget, in one sentence.
#include <chrono>

#include "script.h"

namespace shadowlab::lua {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string end_of_budget = " in one go; does a loop never end?";
const std::string end_of_memory = "the recipe needs more than 16 MiB of memory";
const std::string too_deep = "functions call each other too deeply (stack overflow)";

struct Attack {
  const char* name;
  const char* text;
};
std::ostream& operator<<(std::ostream& out, const Attack& attack) { return out << attack.name; }

std::string name_of(const testing::TestParamInfo<Attack>& info) { return info.param.name; }

class Endless : public testing::TestWithParam<Attack> {};

// Runs the script to its end, whose sentence is given, and checks that it came in time: the budget
// is half a second, and one instruction on a block of 16 MiB may take longer than its share.
std::string timed_error(const Attack& attack) {
  Script script;
  const auto start = std::chrono::steady_clock::now();
  const std::string sentence = script.error(attack.text);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 3.0);
  EXPECT_THAT(script.printed(), testing::Not(HasSubstr("escaped")));
  return sentence;
}

TEST_P(Endless, ends_with_the_budget) {
  EXPECT_THAT(timed_error(GetParam()), AllOf(StartsWith("a.lua:"), HasSubstr(end_of_budget)));
}

INSTANTIATE_TEST_SUITE_P(
    Sandbox, Endless,
    testing::Values(
        Attack{"loop", "while true do end"}, Attack{"goto", "::again:: goto again"},
        Attack{"pcall", "pcall(function() while true do end end) print 'escaped'"},
        Attack{"pcall_again_and_again",
               "while true do pcall(function() while true do end end) print 'escaped' end"},
        Attack{"pcall_recursion",
               "local function f() while true do pcall(f) end end f() print 'escaped'"},
        Attack{"pcall_of_errors", "while true do pcall(error, {}) end"},
        Attack{"xpcall_handler",
               "xpcall(function() while true do end end, function() print 'escaped' while true do "
               "end end)"},
        Attack{"xpcall_handler_of_an_error",
               "xpcall(error, function() while true do end end) print 'escaped'"},
        Attack{"xpcall_handler_that_fails",
               "local function h() error(setmetatable({}, {__tostring = function() while true do "
               "end end})) end while true do xpcall(h, h) end"},
        Attack{"coroutine", "coroutine.wrap(function() while true do end end)() print 'escaped'"},
        Attack{"coroutine_in_pcall",
               "pcall(coroutine.wrap(function() pcall(function() while true do end end) print "
               "'escaped' end)) print 'escaped'"},
        Attack{"coroutine_resume",
               "local co = coroutine.create(function() while true do end end)\n"
               "coroutine.resume(co) print 'escaped' coroutine.resume(co)"},
        Attack{"many_short_coroutines",
               "while true do coroutine.wrap(function() for i = 1, 100 do end end)() end"},
        Attack{"chain_of_coroutines",
               "local function f() coroutine.wrap(f)() end while true do pcall(f) end"},
        Attack{"coroutines_that_yield",
               "local co = coroutine.wrap(function() while true do coroutine.yield() end end) "
               "while true do co() end"},
        Attack{"coroutine_handler",
               "xpcall(coroutine.wrap(function() while true do end end), function() print "
               "'escaped' end)"},
        Attack{"sort_comparator",
               "table.sort({3, 2, 1}, function() while true do end end) print 'escaped'"},
        Attack{"sort_with_lying_comparator",
               "local t = {} for i = 1, 1e4 do t[i] = i end\n"
               "while true do table.sort(t, function() return true end) end"},
        Attack{"tostring",
               "print(setmetatable({}, {__tostring = function() while true do end end}))"},
        Attack{"tostring_of_an_error",
               "error(setmetatable({}, {__tostring = function() while true do end end}))"},
        Attack{"index", "return setmetatable({}, {__index = function() while true do end end}).x"},
        Attack{"concat_metamethod",
               "return {} .. setmetatable({}, {__concat = function() while true do end end})"},
        Attack{"pairs_metamethod",
               "for _ in pairs(setmetatable({}, {__pairs = function() while true do end end})) do "
               "end"},
        Attack{"ipairs",
               "for _ in ipairs(setmetatable({}, {__index = function() return 1 end})) do end"},
        Attack{"gsub_callback", "('x'):gsub('x', function() while true do end end)"},
        Attack{"gmatch_iterator", "while true do for _ in ('x'):rep(1000):gmatch('.') do end end"},
        Attack{"backtracking_pattern",
               "return ('a'):rep(40):find(('a?'):rep(40) .. ('a'):rep(40))"},
        Attack{"backtracking_lazy_pattern", "return ('a'):rep(200):match('.-.-.-.-.-.-.-.-.-b')"},
        Attack{"pattern_from_every_place", "return ('a'):rep(2^20):find('.-b')"},
        Attack{"balanced_from_every_place", "return ('('):rep(2^20):find('%b()')"},
        Attack{"pattern_in_gsub", "return ('a'):rep(40):gsub(('a?'):rep(40) .. ('a'):rep(40), '')"},
        Attack{
            "pattern_in_pcall",
            "pcall(string.find, ('a'):rep(40), ('a?'):rep(40) .. ('a'):rep(40)) print 'escaped'"},
        Attack{
            "plain_find",
            "local s = ('a'):rep(2^20) while true do s:find(('a'):rep(2^19) .. 'b', 1, true) end"},
        Attack{"close_metamethod_set_later",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "do local x <close> = t end print 'escaped'"},
        Attack{"close_while_the_budget_ends",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() print 'escaped' while true do end end\n"
               "local x <close> = t while true do end"},
        Attack{"close_in_a_dead_coroutine",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() print 'escaped' while true do end end\n"
               "local co = coroutine.create(function() local x <close> = t while true do end end)\n"
               "pcall(coroutine.resume, co) print 'escaped' coroutine.close(co)"},
        Attack{"close_of_a_suspended_coroutine",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "local co = coroutine.create(function() local x <close> = t coroutine.yield() end)\n"
               "coroutine.resume(co) coroutine.close(co) print 'escaped'"},
        Attack{"close_by_a_generic_for",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "for _ in function() end, nil, nil, t do end print 'escaped'"},
        Attack{"closes_in_a_deep_stack",
               "local m = {__index = {}} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do pcall(error) end end\n"
               "local function f() local x <close> = t f() end pcall(f)"},
        Attack{"long_comparisons",
               "local a, b = ('x'):rep(2^22) .. 'a', ('x'):rep(2^22) .. 'a' while a == b do end"},
        Attack{"long_order_comparisons",
               "local a, b = ('x'):rep(2^22) .. 'a', ('x'):rep(2^22) .. 'b' while a < b do end"},
        Attack{"long_concatenations",
               "local s = ('x'):rep(2^22) while true do local t = s .. 'y' end"},
        Attack{"long_copies",
               "local s = ('x'):rep(2^21) while true do local t = s:upper():reverse() end"},
        Attack{"utf8_length", "local s = ('x'):rep(2^22) while true do utf8.len(s) end"},
        Attack{"rehashing_a_full_table",
               "local t = {} for i = 1, 2^16 do t[i + 0.5] = true end\n"
               "local k = 0.5 while true do k = k + 1 t[k] = nil t[-k] = true end"},
        Attack{"pairs_of_a_large_table",
               "local t = {} for i = 1, 2^15 do t['k' .. i] = i end while true do pairs(t) end"},
        Attack{"next_of_a_large_table",
               "local t = {} for i = 1, 2^15 do t[i] = i end for _ in next, t do end"},
        Attack{"refused_memory",
               "while true do pcall(function() local s = ('x'):rep(15 * 2^20) .. 'y' end) end"},
        Attack{"table_move_up_and_down",
               "local t = {} while true do table.move(t, 1, 2^26, 2) end"},
        Attack{"table_insert_in_front", "local t = {} while true do table.insert(t, 1, 1) end"},
        Attack{"undefined_names", "while true do pcall(function() return undefined_name end) end"},
        Attack{"print_flood", "while true do print 'x' end"}),
    name_of);

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
  Script script;
  const Attack attacks[] = {
      {"pcall", "local function f() return pcall(f) end return f()"},
      {"xpcall", "local function f() return xpcall(f, f) end return f()"},
      {"closing",
       "local m = {} local all = {}\n"
       "m.__close = function(t) if t.next then coroutine.close(t.next) end end\n"
       "local last\n"
       "for i = 1, 10000 do\n"
       "  local t = setmetatable({next = last}, m)\n"
       "  last = coroutine.create(function() local x <close> = t coroutine.yield() end)\n"
       "  coroutine.resume(last)\n"
       "end\n"
       "return coroutine.close(last)"}};
  for (const Attack& attack : attacks) {
    try {
      Script(small_limits()).value(attack.text);
    } catch (const InputError& problem) {
      EXPECT_THAT(problem.what(), StartsWith("a.lua:")) << attack.name;
    }
  }
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
  EXPECT_EQ(script.value("local m = {} local t = setmetatable({}, m) m.__gc = function() print "
                         "'escaped' end t = nil"),
            "nil");
  lua_gc(script.raw(), LUA_GCCOLLECT);
  EXPECT_EQ(script.printed(), "");
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
                           "m.__close = function() print 'escaped' while true do end end\n"
                           "co = coroutine.create(function() local x <close> = t while true do end "
                           "end) coroutine.resume(co)"),
              HasSubstr(end_of_budget));
  script.state().restart_budget();
  EXPECT_EQ(script.value("return coroutine.status(co)"), "dead");
  EXPECT_EQ(script.value("return coroutine.close(co)"), "false");
  EXPECT_EQ(script.printed(), "");
}

TEST(Sandbox, an_interrupted_parent_of_a_coroutine_does_not_go_on) {
  Script script;
  EXPECT_THAT(script.error("local m = {} local t = setmetatable({}, m)\n"
                           "m.__close = function() print 'escaped' end\n"
                           "local x <close> = t\n"
                           "coroutine.wrap(function() while true do end end)()"),
              HasSubstr(end_of_budget));
  EXPECT_EQ(script.printed(), "");
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
