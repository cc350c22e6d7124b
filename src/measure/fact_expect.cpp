#include "measure/fact_expect.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/state.h"
#include "lua/value.h"

namespace shadowlab::measure {
namespace {

std::string text_at(lua_State* L, int index) {
  const std::string text(lua::push_text(L, index));
  lua_pop(L, 1);
  return lua_type(L, index) == LUA_TSTRING ? "\"" + text + "\"" : text;
}

// What the test adds to the sentence, at `index`: "" or ": WORDS".
std::string words(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TSTRING ? std::string(": ") + lua_tostring(L, index) : "";
}

int expect(lua_State* L) {
  if (!lua_toboolean(L, 1)) throw InputError("expected something else" + words(L, 2));
  return 0;
}

int expect_equal(lua_State* L) {
  luaL_checkany(L, 2);
  if (lua_compare(L, 1, 2, LUA_OPEQ)) return 0;
  throw InputError(fmt::format("{} is not {}{}", text_at(L, 1), text_at(L, 2), words(L, 3)));
}

template <class V>
bool append(lua_State* L, int index, std::vector<double>& numbers) {
  const V* vector = lua::test<V>(L, index);
  if (!vector) return false;
  for (glm::length_t i = 0; i < V::length(); ++i) numbers.push_back((*vector)[i]);
  return true;
}

std::vector<double> numbers_at(lua_State* L, int index) {
  std::vector<double> numbers;
  if (append<glm::dvec2>(L, index, numbers) || append<glm::dvec3>(L, index, numbers) ||
      append<glm::dvec4>(L, index, numbers)) {
    return numbers;
  }
  return {lua::read<double>(L, index, "what expect_near compares")};
}

int expect_near(lua_State* L) {
  const auto a = numbers_at(L, 1), b = numbers_at(L, 2);
  const double tolerance = lua::read<double>(L, 3, "the tolerance of expect_near");
  if (lua_type(L, 4) != LUA_TSTRING)
    throw InputError("expect_near takes the tolerance's reason as its fourth argument");
  bool near = a.size() == b.size();
  for (std::size_t i = 0; near && i < a.size(); ++i) near = std::abs(a[i] - b[i]) <= tolerance;
  if (near) return 0;
  throw InputError(fmt::format("{} is not {} within {} ({})", text_at(L, 1), text_at(L, 2),
                               tolerance, lua_tostring(L, 4)));
}

int expect_error(lua_State* L) {
  const std::string part = luaL_checkstring(L, 2);
  lua_pushvalue(L, 1);
  const int status = lua_pcall(L, 0, 0, 0);
  if (lua::State::of(L).exhausted()) return lua_error(L);
  if (status == LUA_OK)
    throw InputError(fmt::format("no error, where \"{}\" was expected{}", part, words(L, 3)));
  const std::string message(lua::push_text(L, -1));
  if (message.find(part) != std::string::npos) return 0;
  throw InputError(fmt::format("the error is \"{}\", not \"{}\"", message, part));
}

}  // namespace

void open_expect(lua_State* L) {
  lua_register(L, "expect", lua::guarded<expect>);
  lua_register(L, "expect_equal", lua::guarded<expect_equal>);
  lua_register(L, "expect_near", lua::guarded<expect_near>);
  lua_register(L, "expect_error", lua::guarded<expect_error>);
}

}  // namespace shadowlab::measure
