#include "lab/random.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "lua/entry.h"
#include "lua/guard.h"
#include "lua/value.h"

namespace shadowlab::lab {
namespace {

using Generator = std::mt19937_64;

// The standard's distributions differ from library to library; its generators do not.
double unit(Generator& generator) { return static_cast<double>(generator() >> 11) * 0x1p-53; }

double between(Generator& generator, double low, double high) {
  return low + (high - low) * unit(generator);
}

Generator& generator_of(lua_State* L) {
  return *static_cast<Generator*>(lua_touserdata(L, lua_upvalueindex(1)));
}

template <class T>
T given(lua_State* L, int index, const char* function) {
  return lua::read<T>(L, index, fmt::format("argument {} of {}", index, function).c_str());
}

void expect_order(double low, double high, const char* function) {
  if (low <= high) return;
  throw InputError(fmt::format("{}: the lowest comes first; {} and {} given", function, low, high));
}

int push_three(lua_State* L, const glm::dvec3& v) {
  lua_createtable(L, 3, 0);
  for (int i = 0; i < 3; ++i) {
    lua_pushnumber(L, v[i]);
    lua_rawseti(L, -2, i + 1);
  }
  return 1;
}

int point(lua_State* L) {
  const auto low = given<glm::dvec3>(L, 1, "random.point");
  const auto high = given<glm::dvec3>(L, 2, "random.point");
  glm::dvec3 drawn;
  for (int i = 0; i < 3; ++i) {
    expect_order(low[i], high[i], "random.point");
    drawn[i] = between(generator_of(L), low[i], high[i]);
  }
  return push_three(L, drawn);
}

// Even over the part of the sphere between two heights (Archimedes: height is even on a sphere).
glm::dvec3 on_sphere(Generator& generator, double lowest, double highest) {
  const double degree = std::numbers::pi / 180;
  const double y = between(generator, std::sin(lowest * degree), std::sin(highest * degree));
  const double around = between(generator, 0, 2 * std::numbers::pi);
  const double r = std::sqrt(std::max(0.0, 1 - y * y));
  return {r * std::cos(around), y, r * std::sin(around)};
}

int direction(lua_State* L) {
  const double lowest = given<double>(L, 1, "random.direction");
  if (!(lowest >= -90 && lowest <= 90)) {
    throw InputError(fmt::format(
        "random.direction takes the lowest elevation in degrees, -90 to 90; {} given", lowest));
  }
  return push_three(L, on_sphere(generator_of(L), lowest, 90));
}

int number(lua_State* L) {
  const double low = given<double>(L, 1, "random.number");
  const double high = given<double>(L, 2, "random.number");
  expect_order(low, high, "random.number");
  lua_pushnumber(L, between(generator_of(L), low, high));
  return 1;
}

int integer(lua_State* L) {
  const double low = given<double>(L, 1, "random.integer");
  const double high = given<double>(L, 2, "random.integer");
  if (low != std::floor(low) || high != std::floor(high) || std::abs(low) > 1e15 ||
      std::abs(high) > 1e15)
    throw InputError("random.integer takes two integers");
  expect_order(low, high, "random.integer");
  const double drawn = low + std::floor(unit(generator_of(L)) * (high - low + 1));
  lua_pushinteger(L, static_cast<lua_Integer>(drawn));
  return 1;
}

int choice(lua_State* L) {
  const auto count = lua_type(L, 1) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, 1)) : 0;
  if (count == 0)
    throw InputError("random.choice takes a table of one or more: random.choice{1, 2}");
  lua_rawgeti(L, 1,
              1 + static_cast<lua_Integer>(unit(generator_of(L)) * static_cast<double>(count)));
  return 1;
}

// The field of the table at 1; raw, so that no code of a manifest runs within.
bool push_field(lua_State* L, const char* name) {
  lua_pushstring(L, name);
  return lua_rawget(L, 1) != LUA_TNIL;
}

std::pair<double, double> range(lua_State* L, const char* name, double low, double high) {
  std::pair<double, double> both{low, high};
  if (push_field(L, name)) {
    const auto v = lua::read<glm::dvec2>(L, -1, fmt::format("{} of random.camera", name).c_str());
    expect_order(v.x, v.y, fmt::format("{} of random.camera", name).c_str());
    both = {v.x, v.y};
  }
  lua_pop(L, 1);
  return both;
}

int camera(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) {
    throw InputError(
        "random.camera takes a table: {around = {0, 0, 0}, distance = {5, 7}, elevation = {20, "
        "50}}");
  }
  glm::dvec3 around(0);
  if (push_field(L, "around")) around = lua::read<glm::dvec3>(L, -1, "around of random.camera");
  double fovy = 45;
  if (push_field(L, "fovy")) fovy = lua::read<double>(L, -1, "fovy of random.camera");
  lua_pop(L, 2);
  const auto [nearest, farthest] = range(L, "distance", 6, 6);
  const auto [lowest, highest] = range(L, "elevation", 10, 60);
  // At 90 degrees the camera's up would be along its view.
  if (!(nearest > 0) || !(lowest > -90 && highest < 90)) {
    throw InputError("random.camera: distances are over 0, elevations between -90 and 90 degrees");
  }
  Generator& generator = generator_of(L);
  const double distance = between(generator, nearest, farthest);
  const glm::dvec3 eye = around + distance * on_sphere(generator, lowest, highest);
  lua_createtable(L, 0, 3);
  push_three(L, eye);
  lua_setfield(L, -2, "eye");
  push_three(L, around);
  lua_setfield(L, -2, "target");
  lua_pushnumber(L, fovy);
  lua_setfield(L, -2, "fovy");
  return 1;
}

constexpr lua::Entry functions[] = {
    {"point", "random.point(low, high)", "A point of a box, as a table of three.",
     lua::guarded<point>},
    {"direction", "random.direction(lowest)",
     "A direction at least `lowest` degrees over the horizon.", lua::guarded<direction>},
    {"number", "random.number(low, high)", "A number.", lua::guarded<number>},
    {"integer", "random.integer(low, high)", "An integer, both ends included.",
     lua::guarded<integer>},
    {"choice", "random.choice{…}", "One of these.", lua::guarded<choice>},
    {"camera", "random.camera{around=, distance=, elevation=, fovy=}",
     "A camera that looks at `around`; ranges are {low, high}, metres and degrees.",
     lua::guarded<camera>},
};

}  // namespace

void open_random(lua_State* L, std::mt19937_64& generator) {
  lua_newtable(L);
  for (const lua::Entry& entry : functions) {
    lua_pushlightuserdata(L, &generator);
    lua_pushcclosure(L, entry.function, 1);
    lua_setfield(L, -2, entry.name);
  }
  lua::refuse_unknown_names(L, -1, "random");
  lua_setglobal(L, "random");
}

}  // namespace shadowlab::lab
