// Scripts that never stop: each must end within the budget, by the count of instructions and by the
// clock, in one sentence.
#include <ctime>
#include <thread>

#include "script.h"

namespace shadowlab::lua {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Endless : public testing::TestWithParam<Attack> {};

void expect_end(const Attack& attack, const Limits& limits) {
  Script script(limits);
  const std::clock_t start = std::clock();
  const std::string sentence = script.error(attack.text);
  const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_THAT(sentence, AllOf(StartsWith("a.lua:"), HasSubstr(end_of_budget)));
  // Of the processor's time, which other programs do not take. The budget is at most half a second;
  // one instruction on a block of 16 MiB may exceed its share, and a sanitizer slows the rest.
  EXPECT_LT(taken, 3.0);
  EXPECT_FALSE(script.escaped());
}

Limits clock_limits(double seconds) {
  Limits limits = small_limits();
  limits.instructions = uncounted;
  limits.seconds = seconds;
  return limits;
}

// By the hook that looks at the clock, and by the one that counts.
TEST(Stopping, a_script_ends_when_it_is_asked_to) {
  for (const std::uint64_t instructions : {uncounted, uncounted - 1}) {
    Limits limits = clock_limits(600);
    limits.instructions = instructions;
    Script script(limits);
    int questions = 0;
    script.state().stop_when([&questions] { return ++questions == 3; });
    EXPECT_EQ(script.error("while true do end"), "a.lua:1: the recipe was stopped");
    EXPECT_EQ(questions, 3);
  }
}

TEST_P(Endless, ends_with_the_count) { expect_end(GetParam(), small_limits()); }

TEST_P(Endless, ends_with_the_clock) { expect_end(GetParam(), clock_limits(0.1)); }

INSTANTIATE_TEST_SUITE_P(
    Sandbox, Endless,
    testing::Values(
        Attack{"loop", "while true do end"}, Attack{"goto", "::again:: goto again"},
        Attack{"pcall", "pcall(function() while true do end end) escaped = true"},
        Attack{"pcall_again_and_again",
               "while true do pcall(function() while true do end end) escaped = true end"},
        Attack{"pcall_recursion",
               "local function f() while true do pcall(f) end end f() escaped = true"},
        Attack{"pcall_of_errors", "while true do pcall(error, {}) end"},
        Attack{"xpcall_handler",
               "xpcall(function() while true do end end, function() escaped = true while true do "
               "end end)"},
        Attack{"xpcall_handler_of_an_error",
               "xpcall(error, function() while true do end end) escaped = true"},
        Attack{"xpcall_handler_that_fails",
               "local function h() error(setmetatable({}, {__tostring = function() while true do "
               "end end})) end while true do xpcall(h, h) end"},
        Attack{"coroutine", "coroutine.wrap(function() while true do end end)() escaped = true"},
        Attack{"coroutine_in_pcall",
               "pcall(coroutine.wrap(function() pcall(function() while true do end end) escaped = "
               "true end)) escaped = true"},
        Attack{"coroutine_resume",
               "local co = coroutine.create(function() while true do end end)\n"
               "coroutine.resume(co) escaped = true coroutine.resume(co)"},
        Attack{"many_short_coroutines",
               "while true do coroutine.wrap(function() for i = 1, 100 do end end)() end"},
        Attack{"chain_of_coroutines",
               "local function f() coroutine.wrap(f)() end while true do pcall(f) end"},
        Attack{"coroutines_that_yield",
               "local co = coroutine.wrap(function() while true do coroutine.yield() end end) "
               "while true do co() end"},
        Attack{"coroutine_handler",
               "xpcall(coroutine.wrap(function() while true do end end), function() escaped = true "
               "end)"},
        Attack{"sort_comparator",
               "table.sort({3, 2, 1}, function() while true do end end) escaped = true"},
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
        Attack{"pattern_in_pcall",
               "pcall(string.find, ('a'):rep(40), ('a?'):rep(40) .. ('a'):rep(40)) escaped = true"},
        Attack{
            "plain_find",
            "local s = ('a'):rep(2^20) while true do s:find(('a'):rep(2^19) .. 'b', 1, true) end"},
        Attack{"close_metamethod_set_later",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "do local x <close> = t end escaped = true"},
        Attack{"close_while_the_budget_ends",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() escaped = true while true do end end\n"
               "local x <close> = t while true do end"},
        Attack{"close_in_a_dead_coroutine",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() escaped = true while true do end end\n"
               "local co = coroutine.create(function() local x <close> = t while true do end end)\n"
               "pcall(coroutine.resume, co) escaped = true coroutine.close(co)"},
        Attack{"close_of_a_suspended_coroutine",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "local co = coroutine.create(function() local x <close> = t coroutine.yield() end)\n"
               "coroutine.resume(co) coroutine.close(co) escaped = true"},
        Attack{"close_by_a_generic_for",
               "local m = {} local t = setmetatable({}, m)\n"
               "m.__close = function() while true do end end\n"
               "for _ in function() end, nil, nil, t do end escaped = true"},
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

TEST(Sandbox, the_clock_ends_scripts_in_several_threads) {
  std::string one, other;
  {
    std::jthread first([&] { one = Script(clock_limits(0.1)).error("while true do end"); });
    std::jthread second([&] { other = Script(clock_limits(0.2)).error("while true do end"); });
  }
  EXPECT_THAT(one, HasSubstr("more than 0.1 seconds"));
  EXPECT_THAT(other, HasSubstr("more than 0.2 seconds"));
}

TEST(Sandbox, the_clock_goes_on_for_a_script_that_ran_another) {
  // The inner script's alarm takes the place of the outer one's while it runs, and no longer.
  Script outer(clock_limits(0.2)), inner(clock_limits(0.1));
  lua_pushlightuserdata(outer.raw(), &inner);
  lua_pushcclosure(
      outer.raw(),
      [](lua_State* L) {
        auto* const other = static_cast<Script*>(lua_touserdata(L, lua_upvalueindex(1)));
        EXPECT_THAT(other->error("while true do end"), HasSubstr("more than 0.1 seconds"));
        return 0;
      },
      1);
  lua_setglobal(outer.raw(), "run_other");
  EXPECT_THAT(outer.error("run_other() while true do end"), HasSubstr("more than 0.2 seconds"));
}

TEST(Sandbox, not_even_a_native_function_runs_after_the_end) {
  Script script;
  EXPECT_THAT(script.error("xpcall(function() while true do end end, print)"),
              HasSubstr(end_of_budget));
  EXPECT_THAT(script.error("xpcall(function() while true do end end, rawset)"),
              HasSubstr(end_of_budget));
  EXPECT_EQ(script.printed(), "");
}

}  // namespace
}  // namespace shadowlab::lua
