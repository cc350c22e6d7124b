// table, on the raw table: no metamethod can make a range endless, and each range is paid for.
#include <algorithm>
#include <string>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// More values than any table within the default memory holds.
constexpr std::uint64_t longest_range = std::uint64_t{1} << 27;
constexpr std::uint64_t cost_of_move = 4;  // of one value, in instructions
constexpr lua_Integer moves_between_payments = 256;

lua_Integer length(lua_State* L, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  return static_cast<lua_Integer>(lua_rawlen(L, index));
}

// The number of values from `first` to `last`; refuses what no table holds.
std::uint64_t range(const char* function, lua_Integer first, lua_Integer last) {
  if (first > last) return 0;
  const std::uint64_t difference =
      static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
  if (difference >= longest_range)
    throw InputError(std::string(function) + ": there are too many places from " +
                     std::to_string(first) + " to " + std::to_string(last));
  return difference + 1;
}

int insert(lua_State* L) {
  const lua_Integer end = length(L, 1) + 1;
  lua_Integer place = end;
  const int count = lua_gettop(L);
  if (count == 3) {
    place = luaL_checkinteger(L, 2);
    luaL_argcheck(L, place >= 1 && place <= end, 2, "position out of bounds");
    State::of(L).check_budget(cost_of_move * range("table.insert", place, end));
    for (lua_Integer i = end; i > place; --i) {
      lua_rawgeti(L, 1, i - 1);
      lua_rawseti(L, 1, i);
    }
  } else if (count != 2) {
    throw InputError("table.insert takes a table, a position if not the end, and a value");
  }
  lua_rawseti(L, 1, place);
  return 0;
}

int remove(lua_State* L) {
  const lua_Integer size = length(L, 1);
  lua_Integer place = luaL_optinteger(L, 2, size);
  if (lua_gettop(L) > 1)
    luaL_argcheck(L, (place >= 1 && place <= size + 1) || (size == 0 && place == 0), 2,
                  "position out of bounds");
  lua_rawgeti(L, 1, place);
  if (place < size) State::of(L).check_budget(cost_of_move * range("table.remove", place, size));
  for (; place < size; ++place) {
    lua_rawgeti(L, 1, place + 1);
    lua_rawseti(L, 1, place);
  }
  lua_pushnil(L);
  lua_rawseti(L, 1, place);
  return 1;
}

int move(lua_State* L) {
  const lua_Integer first = luaL_checkinteger(L, 2);
  const lua_Integer last = luaL_checkinteger(L, 3);
  const lua_Integer to = luaL_checkinteger(L, 4);
  const int target = lua_isnoneornil(L, 5) ? 1 : 5;
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, target, LUA_TTABLE);
  const auto count = static_cast<lua_Integer>(range("table.move", first, last));
  luaL_argcheck(L, to <= LUA_MAXINTEGER - count, 4, "destination wrap around");
  // Where the target overlaps the rest of the source, from the end.
  const bool same = lua_rawequal(L, 1, target) != 0;
  const bool backwards = same && to > first && to <= last;
  for (lua_Integer k = 0; k < count; ++k) {
    if (k % moves_between_payments == 0)
      State::of(L).check_budget(cost_of_move * moves_between_payments);
    const lua_Integer i = backwards ? count - 1 - k : k;
    lua_rawgeti(L, 1, first + i);
    lua_rawseti(L, target, to + i);
  }
  lua_pushvalue(L, target);
  return 1;
}

int concat(lua_State* L) {
  const lua_Integer size = length(L, 1);
  std::size_t separator_length = 0;
  const char* separator = luaL_optlstring(L, 2, "", &separator_length);
  const lua_Integer first = luaL_optinteger(L, 3, 1);
  const lua_Integer last = luaL_optinteger(L, 4, size);
  const auto count = static_cast<lua_Integer>(range("table.concat", first, last));
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  for (lua_Integer i = 0; i < count; ++i) {
    if (i > 0) luaL_addlstring(&text, separator, separator_length);
    lua_rawgeti(L, 1, first + i);
    if (!lua_isstring(L, -1))
      return luaL_error(L, "table.concat: the value at %I is a %s, not a string or number",
                        first + i, luaL_typename(L, -1));
    luaL_addvalue(&text);
    State::of(L).check_budget(cost_of_move);
  }
  luaL_pushresult(&text);
  return 1;
}

int pack(lua_State* L) {
  const int count = lua_gettop(L);
  lua_createtable(L, count, 1);
  lua_insert(L, 1);
  for (int i = count; i >= 1; --i) lua_rawseti(L, 1, i);
  lua_pushinteger(L, count);
  lua_setfield(L, 1, "n");
  return 1;
}

int unpack(lua_State* L) {
  const lua_Integer size = length(L, 1);
  const lua_Integer first = luaL_optinteger(L, 2, 1);
  const lua_Integer last = luaL_optinteger(L, 3, size);
  const std::uint64_t count = range("table.unpack", first, last);
  State::of(L).check_budget(count);
  if (!lua_checkstack(L, static_cast<int>(count)))
    return luaL_error(L, "table.unpack: too many values to unpack");
  for (lua_Integer i = 0; i < static_cast<lua_Integer>(count); ++i) lua_rawgeti(L, 1, first + i);
  return static_cast<int>(count);
}

// Whether the value at `a` comes before that at `b`, by the function at 2 or by <.
bool comes_before(lua_State* L, int a, int b) {
  State::of(L).check_budget(cost_of_move);
  if (lua_isnil(L, 2)) return lua_compare(L, a, b, LUA_OPLT) != 0;
  lua_pushvalue(L, 2);
  lua_pushvalue(L, a - 1);
  lua_pushvalue(L, b - 2);
  lua_call(L, 2, 1);
  const bool before = lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  return before;
}

// Merges the sorted runs [low, middle) and [middle, high) of the table at 3 into the table at 4.
void merge(lua_State* L, lua_Integer low, lua_Integer middle, lua_Integer high) {
  lua_Integer left = low, right = middle;
  for (lua_Integer out = low; out < high; ++out) {
    lua_rawgeti(L, 3, left);
    lua_rawgeti(L, 3, right);
    const bool take_right = left >= middle || (right < high && comes_before(L, -1, -2));
    if (!take_right) lua_pop(L, 1);
    lua_rawseti(L, 4, out);
    if (take_right) lua_pop(L, 1);
    ++(take_right ? right : left);
  }
}

// A stable merge sort on copies: a comparator may be inconsistent, raise, or change the table, and
// the sort still ends after n log n comparisons in an order that depends on nothing else.
int sort(lua_State* L) {
  const lua_Integer size = length(L, 1);
  if (!lua_isnoneornil(L, 2)) luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_settop(L, 2);
  const std::uint64_t count = range("table.sort", 1, size);
  State::of(L).check_budget(cost_of_move * count);
  for (int copy = 0; copy < 2; ++copy) lua_createtable(L, static_cast<int>(count), 0);
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_rawgeti(L, 1, i);
    lua_rawseti(L, 3, i);
  }
  for (lua_Integer run = 1; run < size; run *= 2) {
    for (lua_Integer low = 1; low <= size; low += 2 * run)
      merge(L, low, std::min(low + run, size + 1), std::min(low + 2 * run, size + 1));
    lua_insert(L, 3);  // what was written is read next
  }
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_rawgeti(L, 3, i);
    lua_rawseti(L, 1, i);
  }
  return 0;
}

constexpr luaL_Reg functions[] = {
    {"concat", guarded<concat>}, {"insert", guarded<insert>}, {"move", guarded<move>},
    {"pack", guarded<pack>},     {"remove", guarded<remove>}, {"sort", guarded<sort>},
    {"unpack", guarded<unpack>}, {nullptr, nullptr},
};

}  // namespace

void add_table(lua_State* L) {
  luaL_newlib(L, functions);
  refuse_unknown_names(L, -1, "table");
  lua_setglobal(L, "table");
}

}  // namespace shadowlab::lua
