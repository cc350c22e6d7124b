// What differs from stock Lua's libraries, and that the rest does not.
#include "script.h"

namespace shadowlab::lua {
namespace {

using testing::HasSubstr;

// The keys that pairs or next visit, in order.
std::string keys(Script& script, const std::string& loop, const std::string& table) {
  return script.value("local t, out = " + table + ", {} for k in " + loop +
                      " do out[#out + 1] = tostring(k) end return table.concat(out, ' ')");
}

TEST(Pairs, visits_numbers_then_strings_then_booleans_in_order) {
  Script script;
  const std::string mixed =
      "{b = 1, a = 1, [true] = 1, [false] = 1, [3] = 1, [1] = 1, [2.5] = 1, [-1] = 1, [1e300] = 1,"
      " [-1/0] = 1, [2^53] = 1, [''] = 1, Z = 1, ['a\\0b'] = 1, [math.mininteger] = 1}";
  const std::string expected =
      "-inf -9223372036854775808 -1 1 2.5 3 9007199254740992 1e+300  Z a a" + std::string(1, '\0') +
      "b b false true";
  EXPECT_EQ(keys(script, "pairs(t)", mixed), expected);
  EXPECT_EQ(keys(script, "next, t", mixed), expected);
  EXPECT_EQ(keys(script, "pairs(t)", "{}"), "");
  EXPECT_EQ(keys(script, "pairs(t)", "{10, 20, nil, 40}"), "1 2 4");
}

TEST(Pairs, a_thousand_names_come_in_the_order_of_their_bytes) {
  Script script;
  EXPECT_EQ(script.value("local t = {} for i = 1, 1000 do t['k' .. i * 7919 % 1000] = i end\n"
                         "local last, n = '', 0\n"
                         "for k, v in pairs(t) do assert(last < k) assert(t[k] == v) last = k "
                         "n = n + 1 end return n"),
            "1000");
}

TEST(Pairs, fields_may_be_changed_and_removed_on_the_way) {
  Script script;
  EXPECT_EQ(script.value("local t, n = {a = 1, b = 2, c = 3}, 0\n"
                         "for k in pairs(t) do n = n + 1 t.b = nil t[k] = nil end return n"),
            "2");
  EXPECT_EQ(script.value("local t, n = {a = 1, b = 2, c = 3}, 0\n"
                         "for k in next, t do n = n + 1 t[k] = nil end return n"),
            "3");
}

TEST(Pairs, respects_the_metamethod) {
  Script script;
  EXPECT_EQ(script.value("local t = setmetatable({}, {__pairs = function(t) return function(_, k) "
                         "if not k then return 1, 'one' end end, t, nil end})\n"
                         "for k, v in pairs(t) do return v end"),
            "one");
}

TEST(Pairs, keys_without_an_order_are_refused_with_the_reason) {
  Script script;
  for (const std::string key : {"{}", "print", "function() end", "coroutine.create(print)"})
    EXPECT_THAT(script.error("pairs({1, [" + key + "] = true})"),
                HasSubstr("has no order that stays the same from run to run"));
  EXPECT_THAT(script.error("return next({a = 1, [{}] = 2}, 'a')"), HasSubstr("has no order"));
  EXPECT_THAT(script.error("return next({}, {})"), HasSubstr("has no order"));
}

TEST(Next, tells_an_empty_table_whatever_its_keys) {
  Script script;
  for (const std::string table : {"{}", "{nil}", "{[{}] = nil}"})
    EXPECT_EQ(script.value("return next(" + table + ") == nil"), "true") << table;
  for (const std::string table :
       {"{1}", "{a = 1}", "{[{}] = 1}", "{[{}] = 1, [print] = 2}", "{[{}] = 1, [{}] = 2, a = 3}"})
    EXPECT_EQ(script.value("return next(" + table + ") == nil"), "false") << table;
  EXPECT_EQ(script.value("return (next({[{}] = 1, [{}] = 2, a = 3}))"), "a");
  EXPECT_EQ(script.value("local k = {} return next({[k] = 1}) == k"), "true");
  EXPECT_THAT(script.error("return next({[{}] = 1, [{}] = 2}).x"), HasSubstr("has no order"));
}

TEST(Globals, an_unknown_name_is_an_error_with_the_near_one) {
  Script script;
  EXPECT_EQ(script.error("local light = 1\nreturn lihgt"),
            "a.lua:2: lihgt is not defined; did you mean light?");
  EXPECT_EQ(script.error("local light = 1 return (function() light = 2 return ligt end)()"),
            "a.lua:1: ligt is not defined; did you mean light?");
  EXPECT_EQ(script.error("camera = 1 return camrea"),
            "a.lua:1: camrea is not defined; did you mean camera?");
  EXPECT_EQ(script.error("return xyzzy"), "a.lua:1: xyzzy is not defined");
  EXPECT_EQ(script.error("return math.sqr(2)"),
            "a.lua:1: math.sqr does not exist; did you mean math.sqrt?");
  EXPECT_EQ(script.error("return unpack {}"),
            "a.lua:1: unpack is not available in a recipe; use table.unpack");
}

TEST(ProtectedCalls, pass_values_and_errors_as_in_stock_lua) {
  Script script;
  EXPECT_EQ(
      script.value("return table.concat({pcall(function(...) return ... end, 1, 2)}, ' ', 2)"),
      "1 2");
  EXPECT_EQ(script.value("return select('#', pcall(function() end))"), "1");
  EXPECT_EQ(script.value("local t = {} return select(2, pcall(error, t)) == t"), "true");
  EXPECT_EQ(script.value("return select(2, xpcall(error, function(e) return e .. '!' end, 'x'))"),
            "x!");
  EXPECT_EQ(script.value("return select('#', xpcall(function(...) return ... end, print, 1, 2))"),
            "3");
  EXPECT_EQ(script.value("local co = coroutine.wrap(function() return pcall(function() "
                         "local x = coroutine.yield(1) error(x, 0) end) end)\n"
                         "co() return select(2, co('late'))"),
            "late");
  EXPECT_EQ(script.value("local co = coroutine.wrap(function() return xpcall(function() "
                         "error(coroutine.yield(1), 0) end, function(e) return e .. '!' end) end)\n"
                         "co() return select(2, co('late'))"),
            "late!");
}

TEST(Coroutines, behave_as_in_stock_lua) {
  Script script;
  EXPECT_EQ(
      script.value("local co = coroutine.create(function(a, b)\n"
                   "  local c = coroutine.yield(a + b)\n"
                   "  local d, e = coroutine.yield(c * 2)\n"
                   "  return d + e end)\n"
                   "local out = {}\n"
                   "local function go(...) local r = {coroutine.resume(co, ...)}\n"
                   "  for i = 1, #r do r[i] = tostring(r[i]) end\n"
                   "  out[#out + 1] = table.concat(r, ' ') .. ' ' .. coroutine.status(co) end\n"
                   "go(1, 2) go(10) go(3, 4) go() return table.concat(out, ', ')"),
      "true 3 suspended, true 20 suspended, true 7 dead, "
      "false cannot resume dead coroutine dead");
  EXPECT_EQ(script.value("local co co = coroutine.wrap(function() return coroutine.status("
                         "coroutine.running()) end) return co()"),
            "running");
  EXPECT_EQ(script.value("return select(2, coroutine.resume(coroutine.running()))"),
            "cannot resume non-suspended coroutine");
  EXPECT_EQ(script.value("local co = coroutine.create(print) return coroutine.close(co) and "
                         "coroutine.status(co)"),
            "dead");
  EXPECT_EQ(script.value("local m = {} local log = ''\n"
                         "local t = setmetatable({}, m) m.__close = function() log = 'closed' end\n"
                         "local co = coroutine.create(function() local x <close> = t "
                         "coroutine.yield() end)\n"
                         "coroutine.resume(co) coroutine.close(co) return log"),
            "closed");
  EXPECT_EQ(script.value("local co = coroutine.create(error) return select('#', "
                         "coroutine.resume(co, 'x'))"),
            "2");
}

TEST(Table, functions_do_what_the_manual_says) {
  Script script;
  const auto list = [&](const std::string& change) {
    return script.value("local t = {1, 2, 3, 4, 5} " + change + " return table.concat(t, ' ')");
  };
  EXPECT_EQ(list("table.insert(t, 6)"), "1 2 3 4 5 6");
  EXPECT_EQ(list("table.insert(t, 1, 0)"), "0 1 2 3 4 5");
  EXPECT_EQ(list("table.insert(t, 6, 0)"), "1 2 3 4 5 0");
  EXPECT_EQ(list("assert(table.remove(t) == 5)"), "1 2 3 4");
  EXPECT_EQ(list("assert(table.remove(t, 1) == 1)"), "2 3 4 5");
  EXPECT_EQ(list("assert(table.remove(t, 6) == nil)"), "1 2 3 4 5");
  EXPECT_EQ(list("table.move(t, 2, 4, 3)"), "1 2 2 3 4");
  EXPECT_EQ(list("table.move(t, 2, 4, 1)"), "2 3 4 4 5");
  EXPECT_EQ(list("t = table.move(t, 1, 3, 2, {0})"), "0 1 2 3");
  EXPECT_EQ(list("t = {table.unpack(t, 2, 4)}"), "2 3 4");
  EXPECT_EQ(list("t = table.pack(table.unpack(t)) t[6] = t.n"), "1 2 3 4 5 5");
  EXPECT_EQ(list("table.sort(t, function(a, b) return a > b end)"), "5 4 3 2 1");
  EXPECT_EQ(script.value("return table.concat({1, 'a', 2.5}, ', ', 2)"), "a, 2.5");
  EXPECT_EQ(script.value("return table.remove({})"), "nil");
  EXPECT_THAT(script.error("table.insert({}, 3, 1)"), HasSubstr("position out of bounds"));
  EXPECT_THAT(script.error("table.insert({}, 1, 2, 3)"), HasSubstr("table.insert takes"));
  EXPECT_THAT(script.error("table.sort({1, 'a'})"), HasSubstr("attempt to compare"));
}

TEST(Table, sort_is_stable_and_right_for_every_length) {
  Script script;
  EXPECT_EQ(script.value("for n = 0, 70 do\n"
                         "  local t = {}\n"
                         "  for i = 1, n do t[i] = {key = i * 37 % 11, place = i} end\n"
                         "  table.sort(t, function(a, b) return a.key < b.key end)\n"
                         "  assert(#t == n)\n"
                         "  for i = 2, n do local a, b = t[i - 1], t[i]\n"
                         "    assert(a.key < b.key or a.key == b.key and a.place < b.place) end\n"
                         "end return 'sorted'"),
            "sorted");
}

TEST(String, format_writes_as_c_does) {
  Script script;
  EXPECT_EQ(script.value("return ('%5d|%-5d|%05d|%+d|% d|%x|%X|%#x|%o'):format(42, 42, 42, 42, 42, "
                         "255, 255, 255, 8)"),
            "   42|42   |00042|+42| 42|ff|FF|0xff|10");
  EXPECT_EQ(script.value("return ('%.3f|%8.2e|%g|%G|%a'):format(1/3, 12345.678, 1e20, 1e-10, 1)"),
            "0.333|1.23e+04|1e+20|1E-10|0x1p+0");
  EXPECT_EQ(script.value("return ('%s|%5s|%-5s|%.2s|%c|%i|%%'):format('ab', 'ab', 'ab', 'abc', 65, "
                         "3.0)"),
            "ab|   ab|ab   |ab|A|3|%");
  EXPECT_EQ(script.value("return ('%q %q %q %q %q'):format('a\"\\n\\0001\\1', 1, 0.5, true, nil)"),
            "\"a\\\"\\\n\\0001\\1\" 1 0x1p-1 true nil");
  EXPECT_EQ(script.value("return #('%99.99f'):format(-1e308)"), "410");
  for (const char* wrong :
       {"%", "%y", "%100d", "%.100f", "%p", "%5q", "%ll", "%n", "%#d", "%-------d"})
    EXPECT_THAT(script.error("return ('" + std::string(wrong) + "'):format(1)"),
                HasSubstr("is no directive"))
        << wrong;
  EXPECT_THAT(script.error("return ('%d'):format(1.5)"), HasSubstr("no integer representation"));
  EXPECT_THAT(script.error("return ('%d'):format()"), HasSubstr("no value"));
}

TEST(String, rep_joins_with_the_separator) {
  Script script;
  EXPECT_EQ(script.value("return ('ab'):rep(3, ', ')"), "ab, ab, ab");
  EXPECT_EQ(script.value("return ('ab'):rep(5)"), "ababababab");
  EXPECT_EQ(script.value("return ('ab'):rep(1, ', ')"), "ab");
  EXPECT_EQ(script.value("return ('ab'):rep(0) .. ('ab'):rep(-1)"), "");
  EXPECT_EQ(script.value("return (''):rep(3, 'x')"), "xx");
  EXPECT_EQ(script.value("return ('a'):rep(1000) == ('a'):rep(10):rep(100)"), "true");
}

TEST(String, gsub_takes_text_table_and_function) {
  Script script;
  EXPECT_EQ(script.value("return (('a b c'):gsub('%w', '%0%0'))"), "aa bb cc");
  EXPECT_EQ(script.value("return (('a b c'):gsub('%w', {a = 1, b = false}))"), "1 b c");
  EXPECT_EQ(script.value("return (('a b c'):gsub('(%w) (%w)', '%2 %1'))"), "b a c");
  EXPECT_EQ(script.value("return (('abc'):gsub('', '-'))"), "-a-b-c-");
  EXPECT_EQ(script.value("return select(2, ('aaa'):gsub('a', 'b', 2))"), "2");
  EXPECT_THAT(script.error("('a'):gsub('a', '%2')"), HasSubstr("capture %2"));
  EXPECT_THAT(script.error("('a'):gsub('a', '%x')"), HasSubstr("followed by a digit"));
  EXPECT_THAT(script.error("('a'):gsub('a', function() return {} end)"),
              HasSubstr("the replacement is a table"));
}

TEST(Random, is_the_same_in_every_state_and_can_be_seeded) {
  const std::string draw =
      "local t = {} for i = 1, 5 do t[i] = math.random(1000) end "
      "return table.concat(t, ' ')";
  Script one, other;
  const std::string first = one.value(draw);
  EXPECT_EQ(other.value(draw), first);
  EXPECT_NE(other.value(draw), first);
  EXPECT_EQ(other.value("math.randomseed() " + draw), first);
  EXPECT_EQ(one.value("math.randomseed(7) " + draw), other.value("math.randomseed(7) " + draw));
  EXPECT_NE(one.value("math.randomseed(7) " + draw), one.value("math.randomseed(8) " + draw));
  EXPECT_NE(one.value("math.randomseed(7, 7) " + draw), one.value("math.randomseed(0, 0) " + draw));
}

TEST(Random, stays_in_its_interval) {
  Script script;
  EXPECT_EQ(script.value("for i = 1, 2000 do\n"
                         "  local u = math.random() assert(u >= 0 and u < 1)\n"
                         "  local d = math.random(6) assert(d >= 1 and d <= 6)\n"
                         "  local n = math.random(-3, -1) assert(n >= -3 and n <= -1)\n"
                         "  assert(math.random(5, 5) == 5)\n"
                         "  assert(math.type(math.random(math.mininteger, math.maxinteger)) == "
                         "'integer')\n"
                         "end return 'inside'"),
            "inside");
  EXPECT_THAT(script.error("math.random(2, 1)"), HasSubstr("interval is empty"));
}

}  // namespace
}  // namespace shadowlab::lua
