// pairs and next in an order of their own. Lua's follows addresses and a hash seed that differ from
// run to run, which must never reach a picture: here come numbers ascending, then strings in the
// order of their bytes, then false and true.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// A key that has a place in the order. The text belongs to Lua: it lives as long as the table holds
// it.
struct Key {
  enum class Kind : unsigned char { integer, real, text, boolean };
  Kind kind;
  int slot = 0;  // where `order_keys` keeps the key itself
  lua_Integer integer = 0;
  lua_Number real = 0;
  std::string_view text;

  bool is_number() const { return kind == Kind::integer || kind == Kind::real; }
};

std::optional<Key> key_at(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      if (lua_isinteger(L, index))
        return Key{.kind = Key::Kind::integer, .integer = lua_tointeger(L, index), .text = {}};
      return Key{.kind = Key::Kind::real, .real = lua_tonumber(L, index), .text = {}};
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* text = lua_tolstring(L, index, &length);
      return Key{.kind = Key::Kind::text, .text = {text, length}};
    }
    case LUA_TBOOLEAN:
      return Key{.kind = Key::Kind::boolean, .integer = lua_toboolean(L, index), .text = {}};
    default:
      return std::nullopt;
  }
}

// Whether an integer key is below a real one. As keys of a table they are never equal: a real key
// has a fraction or is beyond all integers.
bool below(lua_Integer integer, lua_Number real) {
  if (real >= 0x1p63) return true;
  if (real < -0x1p63) return false;
  return integer <= static_cast<lua_Integer>(std::floor(real));
}

bool operator<(const Key& a, const Key& b) {
  if (a.is_number() != b.is_number()) return a.is_number();
  if (a.is_number()) {
    if (a.kind == b.kind)
      return a.kind == Key::Kind::integer ? a.integer < b.integer : a.real < b.real;
    return a.kind == Key::Kind::integer ? below(a.integer, b.real) : !below(b.integer, a.real);
  }
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.kind == Key::Kind::text ? a.text < b.text : a.integer < b.integer;
}

[[noreturn]] void refuse_order(lua_State* L, const char* what, int key) {
  throw InputError(std::string(what) +
                   " needs keys that are numbers, strings or booleans: a key that"
                   " is a " +
                   luaL_typename(L, key) +
                   " has no order that stays the same from run to run; keep such keys in a list");
}

std::size_t count_keys(lua_State* L, int table) {
  std::size_t count = 0;
  for (lua_pushnil(L); lua_next(L, table); lua_pop(L, 1)) ++count;
  return count;
}

// Pushes a list of the table's keys in order. All memory is Lua's, within the script's cap.
void push_ordered_keys(lua_State* L, int table) {
  const std::size_t count = count_keys(L, table);
  State::of(L).check_budget(10 * count);
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError("pairs: this table has too many keys");
  lua_createtable(L, static_cast<int>(count), 0);
  const int found = lua_gettop(L);
  auto* const keys = static_cast<Key*>(lua_newuserdatauv(L, (count + 1) * sizeof(Key), 0));
  bool in_order = true;
  int n = 0;
  for (lua_pushnil(L); lua_next(L, table); lua_pop(L, 1)) {
    const std::optional<Key> key = key_at(L, -2);
    if (!key) refuse_order(L, "pairs", -2);
    new (keys + n) Key(*key);
    keys[n].slot = n + 1;
    in_order = in_order && (n == 0 || keys[n - 1] < keys[n]);
    ++n;
    lua_pushvalue(L, -2);
    lua_rawseti(L, found, n);
  }
  if (in_order) {
    lua_pop(L, 1);
    return;
  }
  std::sort(keys, keys + n);
  lua_createtable(L, n, 0);
  for (int i = 0; i < n; ++i) {
    lua_rawgeti(L, found, keys[i].slot);
    lua_rawseti(L, -2, i + 1);
  }
  lua_replace(L, found);
  lua_settop(L, found);
}

// The iterator of pairs; upvalues: the table, its keys in order, how many of them are done.
int next_pair(lua_State* L) {
  lua_Integer done = lua_tointeger(L, lua_upvalueindex(3));
  lua_settop(L, 0);
  while (lua_rawgeti(L, lua_upvalueindex(2), ++done) != LUA_TNIL) {
    lua_pushvalue(L, 1);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) {
      lua_pushinteger(L, done);
      lua_replace(L, lua_upvalueindex(3));
      return 2;
    }
    lua_settop(L, 0);  // removed since pairs was called
    State::of(L).check_budget(1);
  }
  return 1;
}

int finish_pairs(lua_State*, int, lua_KContext) { return 3; }

int pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_callk(L, 1, 3, 0, finish_pairs);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  lua_pushvalue(L, 1);
  push_ordered_keys(L, 1);
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, guarded<next_pair>, 3);
  lua_insert(L, 1);
  lua_pushnil(L);
  return 3;
}

int refuse_stand_in(lua_State* L) { refuse_order(L, "next", 1); }

// Stands for some key, where a table has several and none of them has a place in the order: enough
// for "is it empty?", and an error once the script uses it.
void push_stand_in(lua_State* L) {
  lua_newuserdatauv(L, 0, 0);
  lua_createtable(L, 0, 4);
  lua_pushliteral(L, "key without an order");
  lua_setfield(L, -2, "__name");
  for (const char* event : {"__index", "__newindex", "__call"}) {
    lua_pushcfunction(L, guarded<refuse_stand_in>);
    lua_setfield(L, -2, event);
  }
  lock_metatable(L, -1);
  lua_setmetatable(L, -2);
}

// next(t, key) looks through the whole table for the key that follows: take pairs for long loops.
int next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  const bool first = lua_isnil(L, 2);
  const std::optional<Key> after = key_at(L, 2);
  if (!first && !after) refuse_order(L, "next", 2);
  if (after && std::isnan(after->real)) throw InputError("next: nan is never a key of a table");
  std::optional<Key> best;
  std::size_t visited = 0, unordered = 0;
  lua_pushnil(L);  // slot 3: the best key so far
  for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
    ++visited;
    const std::optional<Key> key = key_at(L, 4);
    if (!key) {
      if (!first) refuse_order(L, "next", 4);
      ++unordered;
      if (best) continue;
    } else if ((after && !(*after < *key)) || (best && !(*key < *best))) {
      continue;
    }
    best = key;
    lua_pushvalue(L, 4);
    lua_replace(L, 3);
  }
  State::of(L).check_budget(4 * visited);
  if (!best && unordered > 1) {
    push_stand_in(L);
    lua_pushboolean(L, 1);
    return 2;
  }
  if (lua_isnil(L, 3)) return 1;
  lua_pushvalue(L, 3);
  lua_rawget(L, 1);
  return 2;
}

}  // namespace

void add_pairs(lua_State* L) {
  lua_pushcfunction(L, guarded<pairs>);
  lua_setglobal(L, "pairs");
  lua_pushcfunction(L, guarded<next>);
  lua_setglobal(L, "next");
}

}  // namespace shadowlab::lua
