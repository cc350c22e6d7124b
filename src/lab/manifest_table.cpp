#include "lab/manifest_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/near_names.h"
#include "lua/value.h"

namespace shadowlab::lab {
namespace {

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string valid_text(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, index, &length);
  return {text, length};
}

}  // namespace

std::string Source::place(std::string_view word) const {
  for (std::size_t at = 0; !word.empty() && (at = text.find(word, at)) != std::string::npos;
       at += word.size()) {
    const bool begins = at == 0 || !in_word(text[at - 1]);
    const bool ends = at + word.size() == text.size() || !in_word(text[at + word.size()]);
    if (!begins || !ends) continue;
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return fmt::format("{}:{}: ", file, line);
  }
  return file + ": ";
}

Table Table::returned(lua_State* L, Source source) {
  if (lua_type(L, -1) != LUA_TTABLE) {
    throw InputError(
        fmt::format("{}: a lab returns a table with title, points and cases; this "
                    "file returns {}",
                    source.file, lua::describe(L, -1)));
  }
  return {L, lua_gettop(L), "the lab", std::move(source)};
}

std::string Table::title(std::string_view field) const {
  return fmt::format("{} of {}", field, name_);
}

void Table::refuse(std::string_view field, const std::string& expectation) const {
  throw InputError(source_.place(case_.empty() ? field : std::string_view(case_)) + title(field) +
                   " " + expectation);
}

void Table::refuse(std::string_view field, const std::string& expectation, int index) const {
  refuse(field, expectation + "; it is " + lua::describe(L_, index));
}

int Table::push(const char* field) const {
  if (!lua_checkstack(L_, 8)) throw InputError(source_.file + ": its tables are nested too deep");
  lua_pushstring(L_, field);
  return lua_rawget(L_, index_);
}

void Table::expect_fields(std::initializer_list<std::string_view> names) const {
  lua_pushnil(L_);
  while (lua_next(L_, index_)) {
    lua_pop(L_, 1);
    const bool named = lua_type(L_, -1) == LUA_TSTRING;
    const std::string key = named ? valid_text(L_, -1) : lua::describe(L_, -1);
    if (named && std::find(names.begin(), names.end(), key) != names.end()) continue;
    const std::vector<std::string_view> known(names);
    refuse(key, "is nothing that is read" + did_you_mean(key, known));
  }
}

std::optional<std::string> Table::text(const char* field) const {
  const int type = push(field);
  if (type == LUA_TNIL) return lua_pop(L_, 1), std::nullopt;
  if (type != LUA_TSTRING) refuse(field, "is a text in quotes", -1);
  std::string found = valid_text(L_, -1);
  if (found.empty()) refuse(field, "is a text that is not empty");
  lua_pop(L_, 1);
  return found;
}

std::string Table::required_text(const char* field) const {
  auto found = text(field);
  if (!found) refuse(field, "is missing");
  return *found;
}

double Table::number(const char* field, double otherwise, double least, double most) const {
  const int type = push(field);
  if (type == LUA_TNIL) return lua_pop(L_, 1), otherwise;
  const double value = lua_tonumber(L_, -1);
  if (type != LUA_TNUMBER || !(value >= least && value <= most))
    refuse(field, fmt::format("is a number from {} to {}", least, most), -1);
  lua_pop(L_, 1);
  return value;
}

bool Table::flag(const char* field, bool otherwise) const {
  const int type = push(field);
  if (type != LUA_TNIL && type != LUA_TBOOLEAN) refuse(field, "is true or false", -1);
  const bool value = type == LUA_TNIL ? otherwise : lua_toboolean(L_, -1) != 0;
  lua_pop(L_, 1);
  return value;
}

glm::dvec3 Table::three(const char* field, glm::dvec3 otherwise) const {
  if (push(field) == LUA_TNIL) return lua_pop(L_, 1), otherwise;
  const auto value = lua::read<glm::dvec3>(
      L_, -1, (source_.place(case_.empty() ? field : case_) + title(field)).c_str());
  if (!std::isfinite(value.x + value.y + value.z)) refuse(field, "has three finite numbers");
  lua_pop(L_, 1);
  return value;
}

std::pair<int, int> Table::size(const char* field, std::pair<int, int> otherwise, int most) const {
  if (push(field) == LUA_TNIL) return lua_pop(L_, 1), otherwise;
  const auto value = lua::read<glm::dvec2>(L_, -1, (source_.place(field) + title(field)).c_str());
  const auto good = [most](double side) {
    return side >= 1 && side <= most && side == std::floor(side);
  };
  if (!good(value.x) || !good(value.y))
    refuse(field, fmt::format("is {{width, height}} in pixels, 1 to {}", most));
  lua_pop(L_, 1);
  return {static_cast<int>(value.x), static_cast<int>(value.y)};
}

std::optional<Table> Table::table(const char* field) const {
  const int type = push(field);
  if (type == LUA_TNIL) return lua_pop(L_, 1), std::nullopt;
  if (type != LUA_TTABLE) refuse(field, "is a table", -1);
  Table inner{L_, lua_gettop(L_), title(field), source_};
  inner.case_ = case_;
  return inner;
}

void Table::each(const char* field,
                 const std::function<void(const Table&, const std::string&)>& read) const {
  const auto inner = table(field);
  if (!inner) return;
  lua_pushnil(L_);
  while (lua_next(L_, inner->index_)) {
    if (lua_type(L_, -2) != LUA_TSTRING) refuse(field, "has names: set = { light = {0, 4, 0} }");
    read(*inner, valid_text(L_, -2));
    lua_pop(L_, 1);
  }
}

void Table::each_of(const char* field, const std::function<void(const Table&)>& read) const {
  const auto list = table(field);
  if (!list) return;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L_, list->index_));
  for (lua_Integer i = 1; i <= count; ++i) {
    const int top = lua_gettop(L_);
    if (lua_rawgeti(L_, list->index_, i) != LUA_TTABLE) refuse(field, "is a list of tables", -1);
    Table one{L_, top + 1, fmt::format("case {}", i), source_};
    if (auto name = one.text("name")) {
      one.case_ = *name;
      one.name_ = fmt::format("the case \"{}\"", *name);
    }
    read(one);
    lua_settop(L_, top);
  }
}

}  // namespace shadowlab::lab
