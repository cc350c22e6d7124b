// string.find, match, gmatch and gsub over our own patterns.
#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/pattern.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

std::string_view text_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(L, index, &length);
  return {text, length};
}

SpendSteps spend_from(lua_State* L) {
  return [&state = State::of(L)](std::uint64_t steps) { state.check_budget(steps); };
}

Pattern compile(lua_State* L, std::string_view text, Pattern::Caret caret) {
  State::of(L).check_budget(text.size());
  return Pattern(text, caret);
}

void push_capture(lua_State* L, std::string_view subject, const Pattern::Capture& capture) {
  if (capture.is_position)
    lua_pushinteger(L, static_cast<lua_Integer>(capture.begin) + 1);
  else
    lua_pushlstring(L, subject.data() + capture.begin, capture.end - capture.begin);
}

int push_captures(lua_State* L, std::string_view subject, const Pattern::Match& match) {
  luaL_checkstack(L, static_cast<int>(match.captures.size()), "too many captures");
  for (const Pattern::Capture& each : match.captures) push_capture(L, subject, each);
  return static_cast<int>(match.captures.size());
}

// The captures, or the whole match where the pattern has none.
int push_captures_or_match(lua_State* L, std::string_view subject, const Pattern::Match& match) {
  if (!match.captures.empty()) return push_captures(L, subject, match);
  push_capture(L, subject, {match.begin, match.end, false});
  return 1;
}

// The offset that argument `index`, a position from 1 or from the end, stands for; past the end of
// the subject where it does.
std::size_t offset_at(lua_State* L, int index, std::size_t length) {
  const lua_Integer position = luaL_optinteger(L, index, 1);
  const auto size = static_cast<lua_Integer>(length);
  if (position > size) return length + (position > size + 1 ? 1 : 0);
  if (position > 0) return static_cast<std::size_t>(position - 1);
  return position == 0 || position < -size ? 0 : static_cast<std::size_t>(size + position);
}

// memmem takes linear time however the two texts repeat themselves.
int find_plain(lua_State* L, std::string_view subject, std::string_view text, std::size_t from) {
  State::of(L).check_budget((subject.size() - from + text.size()) / 16);
  const void* found =
      memmem(subject.data() + from, subject.size() - from, text.data(), text.size());
  if (!found) {
    lua_pushnil(L);
    return 1;
  }
  const auto begin = static_cast<const char*>(found) - subject.data();
  lua_pushinteger(L, begin + 1);
  lua_pushinteger(L, begin + static_cast<lua_Integer>(text.size()));
  return 2;
}

int find(lua_State* L) {
  const std::string_view subject = text_at(L, 1), text = text_at(L, 2);
  const std::size_t from = offset_at(L, 3, subject.size());
  if (from > subject.size()) {
    lua_pushnil(L);
    return 1;
  }
  if (lua_toboolean(L, 4) || Pattern::is_plain(text)) return find_plain(L, subject, text, from);
  Pattern::Match match;
  if (!compile(L, text, Pattern::Caret::anchors).find(subject, from, spend_from(L), match)) {
    lua_pushnil(L);
    return 1;
  }
  lua_pushinteger(L, static_cast<lua_Integer>(match.begin) + 1);
  lua_pushinteger(L, static_cast<lua_Integer>(match.end));
  return 2 + push_captures(L, subject, match);
}

int match(lua_State* L) {
  const std::string_view subject = text_at(L, 1), text = text_at(L, 2);
  const std::size_t from = offset_at(L, 3, subject.size());
  Pattern::Match found;
  if (from <= subject.size() &&
      compile(L, text, Pattern::Caret::anchors).find(subject, from, spend_from(L), found))
    return push_captures_or_match(L, subject, found);
  lua_pushnil(L);
  return 1;
}

// Gives one match after another. An empty match right behind the one before does not count.
class Matches {
 public:
  Matches(std::string_view subject, std::size_t from) : subject_(subject), from_(from) {}
  Matches(std::string_view subject, std::size_t from, std::size_t last_end)
      : subject_(subject), from_(from), last_end_(last_end) {}

  bool next(const Pattern& pattern, const SpendSteps& spend, Pattern::Match& match) {
    while (from_ <= subject_.size() && pattern.find(subject_, from_, spend, match)) {
      if (match.end != last_end_) {  // only an empty match ends where the last one did
        from_ = last_end_ = match.end;
        return true;
      }
      if (pattern.anchored()) return false;
      from_ = match.begin + 1;
    }
    return false;
  }
  std::size_t from() const { return from_; }

 private:
  std::string_view subject_;
  std::size_t from_;
  std::size_t last_end_ = std::string_view::npos;
};

// The iterator of gmatch; upvalues: subject, pattern, where to go on, where the last match ended or
// -1.
int next_match(lua_State* L) {
  const std::string_view subject = text_at(L, lua_upvalueindex(1));
  const Pattern pattern = compile(L, text_at(L, lua_upvalueindex(2)), Pattern::Caret::literal);
  Matches matches(subject, static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3))),
                  static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(4))));
  Pattern::Match match;
  if (!matches.next(pattern, spend_from(L), match)) return 0;
  for (const int upvalue : {3, 4}) {
    lua_pushinteger(L, static_cast<lua_Integer>(matches.from()));
    lua_replace(L, lua_upvalueindex(upvalue));
  }
  return push_captures_or_match(L, subject, match);
}

int gmatch(lua_State* L) {
  const std::string_view subject = text_at(L, 1);
  compile(L, text_at(L, 2), Pattern::Caret::literal);  // a malformed one raises here
  const std::size_t from = offset_at(L, 3, subject.size());
  lua_settop(L, 2);
  lua_pushinteger(L, static_cast<lua_Integer>(from));
  lua_pushinteger(L, -1);
  lua_pushcclosure(L, guarded<next_match>, 4);
  return 1;
}

// Adds the replacement text with %0 to %9 and %% replaced.
void add_template(lua_State* L, luaL_Buffer* result, std::string_view subject,
                  const Pattern::Match& match) {
  const std::string_view text = text_at(L, 3);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t percent = std::min(text.find('%', i), text.size());
    luaL_addlstring(result, text.data() + i, percent - i);
    if (percent == text.size()) return;
    const char c = percent + 1 < text.size() ? text[percent + 1] : '\0';
    i = percent + 2;
    const std::size_t index = static_cast<std::size_t>(c - '1');
    if (c == '%') {
      luaL_addchar(result, '%');
    } else if (c == '0' || (c == '1' && match.captures.empty())) {
      luaL_addlstring(result, subject.data() + match.begin, match.end - match.begin);
    } else if (c >= '1' && c <= '9' && index < match.captures.size()) {
      push_capture(L, subject, match.captures[index]);
      lua_tolstring(L, -1, nullptr);  // a position becomes its digits
      luaL_addvalue(result);
    } else if (c >= '1' && c <= '9') {
      throw InputError(std::string("string.gsub: the replacement text names capture %") + c +
                       ", which the pattern does not have");
    } else {
      throw InputError("string.gsub: '%' in the replacement text is followed by a digit or by %");
    }
  }
}

void add_replacement(lua_State* L, luaL_Buffer* result, std::string_view subject,
                     const Pattern::Match& match) {
  const int type = lua_type(L, 3);
  if (type == LUA_TSTRING || type == LUA_TNUMBER) return add_template(L, result, subject, match);
  if (type == LUA_TTABLE) {
    Pattern::Match first = match;
    first.captures.resize(std::min<std::size_t>(match.captures.size(), 1));
    push_captures_or_match(L, subject, first);
    lua_gettable(L, 3);
  } else {
    lua_pushvalue(L, 3);
    lua_call(L, push_captures_or_match(L, subject, match), 1);
  }
  if (!lua_toboolean(L, -1)) {
    lua_pop(L, 1);
    luaL_addlstring(result, subject.data() + match.begin, match.end - match.begin);
    return;
  }
  if (!lua_isstring(L, -1))
    throw InputError(std::string("string.gsub: the replacement is a ") + luaL_typename(L, -1) +
                     ", not a string or number");
  luaL_addvalue(result);
}

int gsub(lua_State* L) {
  const std::string_view subject = text_at(L, 1);
  const Pattern pattern = compile(L, text_at(L, 2), Pattern::Caret::anchors);
  const int type = lua_type(L, 3);
  luaL_argexpected(
      L, type == LUA_TSTRING || type == LUA_TNUMBER || type == LUA_TTABLE || type == LUA_TFUNCTION,
      3, "string, function or table");
  if (type == LUA_TNUMBER) lua_tolstring(L, 3, nullptr);
  lua_Integer left = luaL_optinteger(L, 4, LUA_MAXINTEGER);
  const SpendSteps spend = spend_from(L);
  Matches matches(subject, 0);
  Pattern::Match match;
  std::size_t copied = 0;
  lua_Integer count = 0;
  luaL_Buffer result;
  luaL_buffinit(L, &result);
  while (left-- > 0 && matches.next(pattern, spend, match)) {
    luaL_addlstring(&result, subject.data() + copied, match.begin - copied);
    add_replacement(L, &result, subject, match);
    copied = match.end;
    ++count;
    if (pattern.anchored()) break;
  }
  luaL_addlstring(&result, subject.data() + copied, subject.size() - copied);
  luaL_pushresult(&result);
  lua_pushinteger(L, count);
  return 2;
}

constexpr luaL_Reg functions[] = {
    {"find", guarded<find>},   {"gmatch", guarded<gmatch>}, {"gsub", guarded<gsub>},
    {"match", guarded<match>}, {nullptr, nullptr},
};

}  // namespace

void add_matching(lua_State* L) { luaL_setfuncs(L, functions, 0); }

}  // namespace shadowlab::lua
