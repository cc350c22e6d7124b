#include "lua/pattern.h"

#include <random>

#include "script.h"

namespace shadowlab::lua {
namespace {

// Stock Lua with its own string library: what our patterns are compared with.
class Stock {
 public:
  Stock() : lua_(luaL_newstate()) { luaL_openlibs(lua_); }
  ~Stock() { lua_close(lua_); }
  Stock(const Stock&) = delete;
  Stock& operator=(const Stock&) = delete;
  lua_State* raw() { return lua_; }

 private:
  lua_State* lua_;
};

// What the chunk returns for a subject and a pattern, or "error".
std::string result(lua_State* L, const std::string& chunk, const std::string& subject,
                   const std::string& pattern) {
  luaL_loadbufferx(L, chunk.data(), chunk.size(), "=test", "t");
  lua_pushlstring(L, subject.data(), subject.size());
  lua_pushlstring(L, pattern.data(), pattern.size());
  std::string text = "error";
  if (lua_pcall(L, 2, 1, 0) == LUA_OK) {
    std::size_t length = 0;
    const char* chars = lua_tolstring(L, -1, &length);
    text.assign(chars, length);
  }
  lua_settop(L, 0);
  return text;
}

// Every use of patterns in one text.
const std::string all_uses = R"(
  local subject, pattern = ...
  local out = {}
  local function add(...)
    for i = 1, select('#', ...) do out[#out + 1] = tostring((select(i, ...))) end
    out[#out + 1] = ';'
  end
  add(subject:find(pattern))
  add(subject:find(pattern, 3))
  add(subject:find(pattern, -2))
  add(subject:match(pattern))
  add(subject:match(pattern, 2))
  for a, b, c in subject:gmatch(pattern) do add(a, b, c) end
  add(subject:gsub(pattern, '<%0>'))
  add(subject:gsub(pattern, '<%1>', 2))
  add(subject:gsub(pattern, {a = 1, ab = 'x', b = false}))
  add(subject:gsub(pattern, function(...) return select('#', ...) end))
  return table.concat(out, ',')
)";

template <std::size_t N>
std::string random_text(std::mt19937& random, const std::array<const char*, N>& parts,
                        std::size_t most) {
  std::string text;
  for (std::size_t left = random() % (most + 1); left > 0; --left) text += parts[random() % N];
  return text;
}

std::string random_pattern(std::mt19937& random) {
  static constexpr std::array<const char*, 30> singles = {
      "a",    "b",     "c",     ".",    "%a",    "%d",   "%s",    "%w",  "%p",   "%u",
      "%L",   "%S",    "[ab]",  "[^a]", "[a-c]", "[%d]", "[%w_]", "[]]", "[^]]", "[a-]",
      "[%]]", "[^%s]", "[.+*]", "%.",   "%(",    "%%",   " ",     "1",   "%x",   "[-a]"};
  static constexpr std::array<const char*, 8> times = {"", "", "", "", "*", "+", "-", "?"};
  static constexpr std::array<const char*, 6> others = {"%b()",    "%bab", "%f[%w]",
                                                        "%f[^%w]", "()",   "%f[%z]"};
  std::string pattern = random() % 6 == 0 ? "^" : "";
  int open = 0, captures = 0;
  bool closed = false;
  for (std::size_t left = 1 + random() % 5; left > 0; --left) {
    switch (random() % 8) {
      case 0:
        pattern += others[random() % others.size()];
        break;
      case 1:
        pattern += '(';
        ++open;
        ++captures;
        break;
      case 2:
        if (open > 0) pattern += ')', --open, closed = true;
        break;
      case 3:
        if (closed && open == 0 && captures > 0) pattern += "%1";
        break;
      default:
        pattern += std::string(singles[random() % singles.size()]) + times[random() % times.size()];
    }
  }
  pattern += std::string(static_cast<std::size_t>(open), ')');
  if (random() % 6 == 0) pattern += '$';
  return pattern;
}

TEST(Pattern, well_formed_ones_match_as_in_stock_lua) {
  static constexpr std::array<const char*, 16> parts = {"a", "b", "c",  "ab", "aa", "1", "23", " ",
                                                        "(", ")", "()", "_",  ".",  "%", "]",  "B"};
  std::mt19937 random(1);
  Stock stock;
  Limits limits;
  Script ours(limits);
  int matched = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::string subject = random_text(random, parts, 12), pattern = random_pattern(random);
    const std::string expected = result(stock.raw(), all_uses, subject, pattern);
    if (pattern.find("%f[%z]") != std::string::npos) continue;  // %z is gone since Lua 5.2
    EXPECT_EQ(result(ours.raw(), all_uses, subject, pattern), expected)
        << "subject \"" << subject << "\" pattern \"" << pattern << '"';
    if (expected != "error" && !expected.starts_with("nil")) ++matched;
  }
  EXPECT_GT(matched, 1000);  // most comparisons are about something
}

TEST(Pattern, classes_and_sets_hold_the_same_bytes_as_in_stock_lua) {
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  Stock stock;
  Script ours;
  for (const char* pattern :
       {".",           "%a",        "%c",     "%d",     "%g",    "%l",    "%p",     "%s",
        "%u",          "%w",        "%x",     "%A",     "%C",    "%D",    "%G",     "%L",
        "%P",          "%S",        "%U",     "%W",     "%X",    "[%a_]", "[^%a_]", "[%A]",
        "[\x80-\xff]", "[^\x01-z]", "[a-%z]", "[%a-z]", "[z-a]", "[a-a]", "[]-a]",  "[]-]",
        "[^]-]",       "[%]-a]",    "%-",     "%]"})
    EXPECT_EQ(result(ours.raw(), all_uses, all, pattern),
              result(stock.raw(), all_uses, all, pattern))
        << pattern;
}

TEST(Pattern, the_manuals_examples) {
  Script script;
  EXPECT_EQ(script.value("return ('  trim me '):match('^%s*(.-)%s*$')"), "trim me");
  EXPECT_EQ(script.value("return (('hello world'):gsub('(%w+)', '%1 %1'))"),
            "hello hello world world");
  EXPECT_EQ(script.value("return (('hello world from Lua'):gsub('(%w+)%s*(%w+)', '%2 %1'))"),
            "world hello Lua from");
  EXPECT_EQ(script.value("return (('THE (quick) fox'):find('%((%a+)%)'))"), "5");
  EXPECT_EQ(script.value("return (('flaaap'):gsub('()aa()', '%1-%2'))"), "fl3-5ap");
  EXPECT_EQ(script.value("return ('f(a(b)c)d'):match('%b()')"), "(a(b)c)");
  EXPECT_EQ(script.value("return (('THE (quick) fox'):gsub('%f[%a]%a+', string.lower))"),
            "the (quick) fox");
  EXPECT_EQ(script.value("return (('x^*$y'):gsub('[%^%*%$]', '.'))"), "x...y");
  EXPECT_EQ(script.value("local t = {} for k, v in ('a=1, b=2'):gmatch('(%w+)=(%w+)') do "
                         "t[#t + 1] = k .. v end return table.concat(t)"),
            "a1b2");
  EXPECT_EQ(script.value("return ('[[x]] ]=]'):match('%[(=*)%[(.-)%]%1%]') == ''"), "true");
}

TEST(Pattern, malformed_ones_are_refused_wherever_the_fault_is) {
  Script script;
  for (const char* pattern : {"%", "a%", "[a", "[]", "[^]", "[%", "(a", "a)", "%1", "(%1)", "()%2",
                              "%0", "%b", "%bx", "%f", "%fa", "((a)"})
    EXPECT_THAT(script.error("('subject'):find('" + std::string(pattern) + "')"),
                testing::StartsWith("a.lua:1: malformed pattern: "))
        << pattern;
  std::string many;
  for (int i = 0; i < 33; ++i) many += "()";
  EXPECT_THAT(script.error("(''):find('" + many + "')"), testing::HasSubstr("more than 32"));
}

TEST(Pattern, steps_are_paid_for) {
  std::uint64_t steps = 0;
  const SpendSteps count = [&](std::uint64_t more) { steps += more; };
  Pattern::Match match;
  EXPECT_FALSE(Pattern("a*b").find(std::string(1000, 'a'), 0, count, match));
  EXPECT_GT(steps, 1000u * 1000u / 2);  // from each place over the rest
  const SpendSteps stop = [](std::uint64_t) { throw InputError("stop"); };
  EXPECT_THROW(Pattern("a*b").find(std::string(10000, 'a'), 0, stop, match), InputError);
}

TEST(Pattern, a_long_subject_needs_no_deep_stack) {
  Script script(Limits{});
  EXPECT_EQ(script.value("return #('a'):rep(2^22):match('^(.-)$')"), "4194304");
  EXPECT_EQ(script.value("return #('a'):rep(2^22):match('^([^b]*)$')"), "4194304");
}

}  // namespace
}  // namespace shadowlab::lua
