// string.format, without %p and with our own text of values: no address reaches a script.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// The longest number: "%99.99f" of the largest double has 309 digits, a point and 99 more.
constexpr std::size_t longest_number = 512;

// One "%-8.3f": flags, width and precision as written.
struct Directive {
  std::string flags;
  std::string width;
  std::string precision;  // with its point; "." alone is ".0"
  char conversion = '\0';

  std::string text() const { return "%" + flags + width + precision + conversion; }
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The directive at `format[at]`, behind the '%'; moves `at` behind it.
Directive directive_at(std::string_view format, std::size_t& at) {
  const auto here = [&] { return at < format.size() ? format[at] : '\0'; };
  Directive found;
  while (here() != '\0' && std::string_view("-+ #0").find(here()) != std::string_view::npos &&
         found.flags.size() < 6)
    found.flags += format[at++];
  while (is_digit(here()) && found.width.size() < 3) found.width += format[at++];
  if (here() == '.') {
    found.precision += format[at++];
    while (is_digit(here()) && found.precision.size() < 4) found.precision += format[at++];
  }
  found.conversion = here();
  if (at < format.size()) ++at;
  return found;
}

// The flags that a conversion takes, and whether it takes a precision.
struct Allowed {
  char conversion;
  std::string_view flags;
  bool precision;
};
constexpr std::array allowed = {
    Allowed{'c', "-", false},    Allowed{'d', "-+0 ", true},  Allowed{'i', "-+0 ", true},
    Allowed{'o', "-#0", true},   Allowed{'x', "-#0", true},   Allowed{'X', "-#0", true},
    Allowed{'a', "-+#0 ", true}, Allowed{'A', "-+#0 ", true}, Allowed{'e', "-+#0 ", true},
    Allowed{'E', "-+#0 ", true}, Allowed{'f', "-+#0 ", true}, Allowed{'g', "-+#0 ", true},
    Allowed{'G', "-+#0 ", true}, Allowed{'s', "-", true},
};

void check(const Directive& directive) {
  if (directive.text() == "%q") return;
  for (const Allowed& each : allowed) {
    if (each.conversion != directive.conversion) continue;
    const bool flags_fit = directive.flags.find_first_not_of(each.flags) == std::string::npos &&
                           directive.flags.size() <= 5;
    if (flags_fit && directive.width.size() <= 2 && directive.precision.size() <= 3 &&
        (each.precision || directive.precision.empty()))
      return;
  }
  const std::string shown = directive.conversion == '\0' || directive.conversion < ' '
                                ? "%" + directive.flags + directive.width + directive.precision
                                : directive.text();
  throw InputError("string.format: '" + shown +
                   "' is no directive; there are %d %i %o %x %X %a %A"
                   " %e %E %f %g %G %c %s %q and %%, with at most two digits of width and of"
                   " precision");
}

template <class Number>
void add_number(luaL_Buffer* result, Directive directive, Number number) {
  if constexpr (std::is_integral_v<Number>)
    if (directive.conversion != 'c') directive.precision += "ll";  // lua_Integer is long long
  char* const room = luaL_prepbuffsize(result, longest_number);
  const int length = std::snprintf(room, longest_number, directive.text().c_str(), number);
  luaL_addsize(result, static_cast<std::size_t>(length));
}

void add_text(lua_State* L, luaL_Buffer* result, const Directive& directive, int argument) {
  push_text(L, argument);
  if (directive.width.empty() && directive.precision.empty()) return luaL_addvalue(result);
  // Copied: while the text is on the stack above it, the buffer must not grow.
  std::size_t length = 0;
  const char* text = lua_tolstring(L, -1, &length);
  const std::size_t width = directive.width.empty() ? 0 : std::stoul(directive.width);
  if (!directive.precision.empty())
    length = std::min<std::size_t>(
        length, directive.precision == "." ? 0 : std::stoul(directive.precision.substr(1)));
  else if (length >= width)
    return luaL_addvalue(result);
  std::string padded(text, length);  // shorter than 100 characters
  lua_pop(L, 1);
  if (padded.size() < width)
    padded.insert(directive.flags.empty() ? 0 : padded.size(), width - padded.size(), ' ');
  luaL_addlstring(result, padded.data(), padded.size());
}

void add_quoted_string(lua_State* L, luaL_Buffer* result, int argument) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, argument, &length);
  luaL_addchar(result, '"');
  for (std::size_t i = 0; i < length; ++i) {
    const char c = text[i];
    if (c == '"' || c == '\\' || c == '\n') {
      luaL_addchar(result, '\\');
      luaL_addchar(result, c);
    } else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
      // Three digits where a digit follows that would be read as one of them.
      const bool digit_follows = i + 1 < length && is_digit(text[i + 1]);
      char code[8];
      std::snprintf(code, sizeof code, digit_follows ? "\\%03d" : "\\%d", c);
      luaL_addstring(result, code);
    } else {
      luaL_addchar(result, c);
    }
  }
  luaL_addchar(result, '"');
}

void add_quoted_float(luaL_Buffer* result, lua_Number number) {
  if (std::isnan(number)) return luaL_addstring(result, "(0/0)");
  if (std::isinf(number)) return luaL_addstring(result, number > 0 ? "1e9999" : "-1e9999");
  char text[longest_number];
  const bool whole = number == std::floor(number);
  std::snprintf(text, sizeof text, whole ? "%.0f" : "%a", number);
  luaL_addstring(result, text);
  if (whole) luaL_addstring(result, "e0");  // stays a float when it is read
}

void add_quoted(lua_State* L, luaL_Buffer* result, int argument) {
  switch (lua_type(L, argument)) {
    case LUA_TSTRING:
      return add_quoted_string(L, result, argument);
    case LUA_TNUMBER:
      if (!lua_isinteger(L, argument)) return add_quoted_float(result, lua_tonumber(L, argument));
      if (lua_tointeger(L, argument) == LUA_MININTEGER)  // has no decimal notation
        return luaL_addstring(result, "0x8000000000000000");
      [[fallthrough]];
    case LUA_TNIL:
    case LUA_TBOOLEAN:
      push_text(L, argument);
      return luaL_addvalue(result);
    default:
      throw InputError("string.format: %q takes a string, a number, a boolean or nil");
  }
}

void add(lua_State* L, luaL_Buffer* result, const Directive& directive, int argument) {
  switch (directive.conversion) {
    case 'q':
      return add_quoted(L, result, argument);
    case 's':
      return add_text(L, result, directive, argument);
    case 'c':
      return add_number(result, directive, static_cast<int>(luaL_checkinteger(L, argument)));
    case 'd':
    case 'i':
    case 'o':
    case 'x':
    case 'X':
      return add_number(result, directive, luaL_checkinteger(L, argument));
    default:
      return add_number(result, directive, luaL_checknumber(L, argument));
  }
}

int format(lua_State* L) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(L, 1, &length);
  const std::string_view pattern(text, length);
  const int last = lua_gettop(L);  // the buffer may put more on the stack
  int argument = 1;
  luaL_Buffer result;
  luaL_buffinit(L, &result);
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t percent = std::min(pattern.find('%', at), pattern.size());
    luaL_addlstring(&result, text + at, percent - at);
    at = percent + 1;
    if (percent == pattern.size()) break;
    if (at < pattern.size() && pattern[at] == '%') {
      luaL_addchar(&result, '%');
      ++at;
      continue;
    }
    const Directive directive = directive_at(pattern, at);
    check(directive);
    if (++argument > last) luaL_argerror(L, argument, "no value");
    add(L, &result, directive, argument);
  }
  luaL_pushresult(&result);
  return 1;
}

}  // namespace

void add_format(lua_State* L) {
  lua_pushcfunction(L, guarded<format>);
  lua_setfield(L, -2, "format");
}

}  // namespace shadowlab::lua
