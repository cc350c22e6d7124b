// math, with random numbers that are the same in every run.
#include <cstring>
#include <random>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

// A number in [0, 1) from the upper 53 bits, as many as a double has.
lua_Number unit(std::uint64_t bits) { return static_cast<lua_Number>(bits >> 11) * 0x1p-53; }

// Every integer of [0, span] with the same probability: draws below the largest multiple of span
// + 1.
std::uint64_t draw_up_to(std::mt19937_64& random, std::uint64_t span) {
  if (span == ~std::uint64_t{0}) return random();
  const std::uint64_t count = span + 1;
  const std::uint64_t rejected = (0 - count) % count;  // 2^64 modulo count
  std::uint64_t drawn = random();
  while (drawn < rejected) drawn = random();
  return drawn % count;
}

int random(lua_State* L) {
  std::mt19937_64& engine = State::of(L).random();
  lua_Integer low = 1, high = 0;
  switch (lua_gettop(L)) {
    case 0:
      lua_pushnumber(L, unit(engine()));
      return 1;
    case 1:
      high = luaL_checkinteger(L, 1);
      if (high == 0) {
        lua_pushinteger(L, static_cast<lua_Integer>(engine()));
        return 1;
      }
      break;
    case 2:
      low = luaL_checkinteger(L, 1);
      high = luaL_checkinteger(L, 2);
      break;
    default:
      throw InputError("math.random takes no, one or two numbers");
  }
  luaL_argcheck(L, low <= high, lua_gettop(L), "interval is empty");
  const auto first = static_cast<std::uint64_t>(low);
  const std::uint64_t span = static_cast<std::uint64_t>(high) - first;
  lua_pushinteger(L, static_cast<lua_Integer>(first + draw_up_to(engine, span)));
  return 1;
}

std::uint64_t seed_at(lua_State* L, int index) {
  int is_integer = 0;
  const lua_Integer integer = lua_tointegerx(L, index, &is_integer);
  if (is_integer) return static_cast<std::uint64_t>(integer);
  const lua_Number real = luaL_checknumber(L, index);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &real, sizeof bits);
  return bits;
}

// Without a seed, the one that every state starts with: never the time.
int random_seed(lua_State* L) {
  std::mt19937_64& engine = State::of(L).random();
  if (lua_isnoneornil(L, 1)) {
    engine.seed();
    return 0;
  }
  // An odd factor keeps seeds apart; two equal ones do not cancel.
  const std::uint64_t second = lua_isnoneornil(L, 2) ? 0 : seed_at(L, 2);
  engine.seed(seed_at(L, 1) ^ (second * 0x9E3779B97F4A7C15u));
  return 0;
}

constexpr luaL_Reg own_functions[] = {
    {"random", guarded<random>},
    {"randomseed", guarded<random_seed>},
    {nullptr, nullptr},
};

}  // namespace

void add_math(lua_State* L) {
  lua_pushcfunction(L, luaopen_math);
  lua_call(L, 0, 1);
  luaL_setfuncs(L, own_functions, 0);
  refuse_unknown_names(L, -1, "math");
  lua_setglobal(L, "math");
}

}  // namespace shadowlab::lua
