// param: what of a recipe can be set, from the command line, by sliders, by a sweep.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lua/boxes.h"

namespace shadowlab::lua {
namespace {

double number(lua_State* L, int index, const char* function) {
  return read<double>(L, index, fmt::format("argument {} of param.{}", index, function).c_str());
}

// Three numbers, or a vector.
std::vector<double> three(lua_State* L, const char* function) {
  if (lua_type(L, 1) == LUA_TNUMBER)
    return {number(L, 1, function), number(L, 2, function), number(L, 3, function)};
  const auto v = read<glm::dvec3>(L, 1, fmt::format("argument 1 of param.{}", function).c_str());
  return {v.x, v.y, v.z};
}

int give(lua_State* L, Parameter parameter) {
  push_box<Parameter>(L, std::move(parameter));
  return 1;
}

int point(lua_State* L) { return give(L, {Parameter::Kind::point, three(L, "point"), 0, 0, {}}); }
int direction(lua_State* L) {
  auto value = three(L, "direction");
  if (value[0] == 0 && value[1] == 0 && value[2] == 0)
    throw InputError("param.direction: a direction has a length");
  return give(L, {Parameter::Kind::direction, std::move(value), 0, 0, {}});
}
int color(lua_State* L) { return give(L, {Parameter::Kind::color, three(L, "color"), 0, 1, {}}); }

int ranged(lua_State* L, Parameter::Kind kind, const char* function) {
  const double value = number(L, 1, function), least = number(L, 2, function),
               most = number(L, 3, function);
  if (!(least <= value && value <= most)) {
    throw InputError(fmt::format("param.{}: the default {} is not between {} and {}", function,
                                 value, least, most));
  }
  return give(L, {kind, {value}, least, most, {}});
}
int any_number(lua_State* L) { return ranged(L, Parameter::Kind::number, "number"); }
int integer(lua_State* L) { return ranged(L, Parameter::Kind::integer, "integer"); }

int choice(lua_State* L) {
  Parameter parameter{Parameter::Kind::choice, {0}, 0, 0, {}};
  const bool table = lua_type(L, 1) == LUA_TTABLE;
  const auto count =
      table ? static_cast<int>(std::min<std::size_t>(lua_rawlen(L, 1), 100)) : lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    if (table) {
      lua_rawgeti(L, 1, i);
    } else {
      lua_pushvalue(L, i);
    }
    if (lua_type(L, -1) != LUA_TSTRING)
      throw InputError("param.choice takes names, the default first; one is " + describe(L, -1));
    parameter.choices.emplace_back(lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  if (parameter.choices.empty()) throw InputError("param.choice takes at least one name");
  return give(L, std::move(parameter));
}

int toggle(lua_State* L) {
  if (!lua_isboolean(L, 1))
    throw InputError("param.toggle takes true or false; it is " + describe(L, 1));
  return give(L, {Parameter::Kind::toggle, {lua_toboolean(L, 1) ? 1.0 : 0.0}, 0, 1, {}});
}

constexpr Entry functions[] = {
    {"point", "param.point(x, y, z)", "A point of the world; r.params has it as a vec4 with w = 1.",
     guarded<point>},
    {"direction", "param.direction(x, y, z)",
     "The direction toward a light at infinity; a vec4 with w = 0.", guarded<direction>},
    {"number", "param.number(default, least, most)", "A number in a range.", guarded<any_number>},
    {"integer", "param.integer(default, least, most)", "An integer in a range.", guarded<integer>},
    {"choice", "param.choice(name, …)", "One of these names; the first is the default.",
     guarded<choice>},
    {"toggle", "param.toggle(default)", "true or false.", guarded<toggle>},
    {"color", "param.color(r, g, b)", "A colour, each from 0 to 1; a vec3.", guarded<color>},
};

std::vector<double> parsed(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    while (at < end && *at == ' ') ++at;
    double value = 0;
    const auto [after, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    at = after;
    while (at < end && *at == ' ') ++at;
    if (at < end && (*at++ != ',' || at == end)) return {};
  }
  return numbers;
}

}  // namespace

const char* name_of(Parameter::Kind kind) {
  static constexpr std::array names{"point",  "direction", "number", "integer",
                                    "choice", "toggle",    "color"};
  return names[static_cast<std::size_t>(kind)];
}

void push_value(lua_State* L, const Parameter& parameter) {
  const auto& v = parameter.value;
  switch (parameter.kind) {
    case Parameter::Kind::point:
      push(L, glm::dvec4(v[0], v[1], v[2], 1));
      break;
    case Parameter::Kind::direction:
      push(L, glm::dvec4(v[0], v[1], v[2], 0));
      break;
    case Parameter::Kind::color:
      push(L, glm::dvec3(v[0], v[1], v[2]));
      break;
    case Parameter::Kind::number:
      lua_pushnumber(L, v[0]);
      break;
    case Parameter::Kind::integer:
      lua_pushinteger(L, static_cast<lua_Integer>(v[0]));
      break;
    case Parameter::Kind::toggle:
      lua_pushboolean(L, v[0] != 0);
      break;
    case Parameter::Kind::choice:
      lua_pushstring(L, parameter.choices[static_cast<std::size_t>(v[0])].c_str());
      break;
  }
}

void set_value(Parameter& parameter, const std::string& name, const std::string& text) {
  const auto refuse = [&](const std::string& takes) {
    throw InputError(fmt::format("parameter {} takes {}; \"{}\" given", name, takes, text));
  };
  const auto numbers = parsed(text);
  switch (parameter.kind) {
    case Parameter::Kind::point:
    case Parameter::Kind::direction:
    case Parameter::Kind::color:
      if (numbers.size() != 3) refuse("three numbers, as in --set " + name + "=2,4,1");
      if (parameter.kind == Parameter::Kind::direction && numbers == std::vector<double>{0, 0, 0})
        refuse("a direction that is not 0,0,0");
      parameter.value = numbers;
      break;
    case Parameter::Kind::number:
    case Parameter::Kind::integer: {
      const bool whole = parameter.kind == Parameter::Kind::integer;
      const bool fits = numbers.size() == 1 && numbers[0] >= parameter.least &&
                        numbers[0] <= parameter.most &&
                        (!whole || numbers[0] == std::floor(numbers[0]));
      if (!fits)
        refuse(fmt::format("{} from {} to {}", whole ? "an integer" : "a number", parameter.least,
                           parameter.most));
      parameter.value = numbers;
      break;
    }
    case Parameter::Kind::toggle:
      if (text == "true" || text == "1" || text == "on") {
        parameter.value = {1};
      } else if (text == "false" || text == "0" || text == "off") {
        parameter.value = {0};
      } else {
        refuse("true or false");
      }
      break;
    case Parameter::Kind::choice: {
      const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
      if (found == parameter.choices.end()) {
        const std::vector<std::string_view> names(parameter.choices.begin(),
                                                  parameter.choices.end());
        std::string listed;
        for (const auto& choice : parameter.choices)
          listed += (listed.empty() ? "" : ", ") + choice;
        throw InputError(fmt::format("parameter {} is one of {}; \"{}\" given{}", name, listed,
                                     text, did_you_mean(text, names)));
      }
      parameter.value = {static_cast<double>(found - parameter.choices.begin())};
      break;
    }
  }
}

std::string text_of(const Parameter& parameter) {
  if (parameter.kind == Parameter::Kind::toggle) return parameter.value[0] != 0 ? "true" : "false";
  if (parameter.kind == Parameter::Kind::choice)
    return parameter.choices[static_cast<std::size_t>(parameter.value[0])];
  return fmt::format("{}", fmt::join(parameter.value, ","));
}

std::span<const Entry> param_functions() { return functions; }

void open_param(Stage& stage) {
  lua_State* L = stage.state.raw();
  open_box<Parameter>(L, {});
  lua_newtable(L);
  set_functions(L, functions);
  refuse_unknown_names(L, -1, "param");
  lua_setglobal(L, "param");
}

}  // namespace shadowlab::lua
