#include "lua/arguments.h"

#include <charconv>
#include <cmath>

#include "core/near_names.h"

namespace shadowlab::lua {
namespace {

/// The numbers that one argument of a constructor brings; none if it brings no numbers.
std::span<const double> numbers_of(lua_State* L, int index, double& number) {
  if (lua_type(L, index) == LUA_TNUMBER) {
    number = lua_tonumber(L, index);
    return {&number, 1};
  }
  if (const auto* v = test<glm::dvec2>(L, index)) return numbers(*v);
  if (const auto* v = test<glm::dvec3>(L, index)) return numbers(*v);
  if (const auto* v = test<glm::dvec4>(L, index)) return numbers(*v);
  return {};
}

std::string bracketed(const std::string& key) { return std::string("[").append(key).append("]"); }

}  // namespace

void gather(lua_State* L, int first, const char* constructor, std::span<double> out) {
  const auto sentence = [&] {
    return std::string(constructor) + " takes " + std::to_string(out.size()) +
           " numbers, which vectors may bring; ";
  };
  std::size_t count = 0;
  for (int index = first; index <= lua_gettop(L); ++index) {
    double number = 0;
    const std::span<const double> brought = numbers_of(L, index, number);
    if (brought.empty()) {
      throw InputError(sentence() + "argument " + std::to_string(index - first + 1) + " is " +
                       describe(L, index));
    }
    for (const double one : brought) {
      if (count < out.size()) out[count] = one;
      ++count;
    }
  }
  if (count != out.size()) throw InputError(sentence() + "it got " + std::to_string(count));
}

std::string field_name(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return bracketed(text(lua_tonumber(L, index)));
  if (lua_type(L, index) != LUA_TSTRING) return bracketed(describe(L, index));
  constexpr std::size_t longest = 40;
  const std::string_view name = lua_tostring(L, index);
  return name.size() <= longest ? std::string(name) : std::string(name.substr(0, longest)) + "...";
}

std::vector<std::string_view> function_names(Kind kind) {
  std::vector<std::string_view> names;
  const Module module = value_modules()[static_cast<std::size_t>(kind)];
  for (const Entry& entry : module.entries) {
    if (!entry.is_metamethod()) names.push_back(entry.name);
  }
  return names;
}

int index_method(lua_State* L, Kind kind) {
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  const std::string field = field_name(L, 2);
  throw InputError("a " + std::string(name(kind)) + " has no " + field +
                   did_you_mean(field, function_names(kind)));
}

std::string text(double number) {
  if (number == 0) return "0";
  if (std::isnan(number)) return "nan";
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string call_text(const char* constructor, std::span<const double> numbers) {
  std::string call = constructor;
  const char* separator = "(";
  for (const double number : numbers) {
    call += separator + text(number);
    separator = ", ";
  }
  return call + ")";
}

}  // namespace shadowlab::lua
