// vec2, vec3 and vec4 in Lua.
#include <algorithm>
#include <array>
#include <iterator>

#include "lua/arguments.h"
#include "lua/guard.h"
#include "lua/operators.h"

namespace shadowlab::lua {
namespace {

template <class V>
constexpr int size = static_cast<int>(sizeof(V) / sizeof(double));
template <class V>
constexpr Function named(const char* name) {
  return {KindOf<V>::value, name};
}

void push_numbers(lua_State* L, std::span<const double> from) {
  switch (from.size()) {
    case 1:
      return lua_pushnumber(L, from[0]);
    case 2:
      return push(L, glm::dvec2(from[0], from[1]));
    case 3:
      return push(L, glm::dvec3(from[0], from[1], from[2]));
    default:
      return push(L, glm::dvec4(from[0], from[1], from[2], from[3]));
  }
}

/// vec3(s), vec3(vec4), vec3{x, y, z}, or numbers and vectors that bring exactly the components.
template <class V>
int construct(lua_State* L) {
  double components[4] = {};
  const std::span<double> out(components, size<V>);
  const auto* longer = test<glm::dvec4>(L, 2);
  if (lua_gettop(L) != 2) {
    gather(L, 2, name(KindOf<V>::value), out);
  } else if (lua_type(L, 2) == LUA_TNUMBER) {
    std::ranges::fill(out, lua_tonumber(L, 2));
  } else if (longer) {
    std::ranges::copy(numbers(*longer).first(out.size()), out.begin());
  } else if (const auto* v = test<glm::dvec3>(L, 2); v && size<V> < 3) {
    std::ranges::copy(numbers(*v).first(out.size()), out.begin());
  } else if (lua_type(L, 2) == LUA_TTABLE) {
    push(L, read<V>(L, 2, ("argument 1 of " + std::string(name(KindOf<V>::value))).c_str()));
    return 1;
  } else {
    gather(L, 2, name(KindOf<V>::value), out);
  }
  push_numbers(L, out);
  return 1;
}

/// The components that the letters name, into `found`: x y z w, or r g b a, never both at once.
/// Returns how many, 0 where the letters name none.
std::size_t swizzle(std::string_view letters, std::span<const double> from,
                    std::span<double, 4> found) {
  if (letters.empty() || letters.size() > 4) return 0;
  for (const std::string_view set : {"xyzw", "rgba"}) {
    std::size_t count = 0;
    for (const char letter : letters) {
      const std::size_t which = set.find(letter);
      if (which >= from.size()) break;
      found[count++] = from[which];
    }
    if (count == letters.size()) return count;
  }
  return 0;
}

template <class V>
int index(lua_State* L) {
  const V& v = self<V>(L);
  if (lua_type(L, 2) == LUA_TNUMBER) {
    const lua_Integer which = lua_tointeger(L, 2);
    if (which >= 1 && which <= size<V>) {
      lua_pushnumber(L, numbers(v)[static_cast<std::size_t>(which - 1)]);
      return 1;
    }
  } else if (lua_type(L, 2) == LUA_TSTRING) {
    std::size_t length = 0;
    const char* letters = lua_tolstring(L, 2, &length);
    double found[4];
    const std::size_t count = swizzle({letters, length}, numbers(v), found);
    if (count > 0) {
      push_numbers(L, {found, count});
      return 1;
    }
  }
  return index_method(L, KindOf<V>::value);
}

template <class V>
int count(lua_State* L) {
  lua_pushinteger(L, size<V>);
  return 1;
}

template <class V>
int to_string(lua_State* L) {
  const V v = argument<V>(L, 1, named<V>("__tostring"));
  lua_pushstring(L, call_text(name(KindOf<V>::value), numbers(v)).c_str());
  return 1;
}

template <class V>
int dot(lua_State* L) {
  constexpr Function f = named<V>("dot");
  lua_pushnumber(L, glm::dot(argument<V>(L, 1, f), argument<V>(L, 2, f)));
  return 1;
}

int cross(lua_State* L) {
  constexpr Function f = named<glm::dvec3>("cross");
  push(L, glm::cross(argument<glm::dvec3>(L, 1, f), argument<glm::dvec3>(L, 2, f)));
  return 1;
}

template <class V>
int length(lua_State* L) {
  lua_pushnumber(L, length_of(argument<V>(L, 1, named<V>("length"))));
  return 1;
}

template <class V>
int normalize(lua_State* L) {
  constexpr Function f = named<V>("normalize");
  push(L, unit(argument<V>(L, 1, f), f, "the vector"));
  return 1;
}

template <class V>
int distance(lua_State* L) {
  constexpr Function f = named<V>("distance");
  const V difference = argument<V>(L, 2, f) - argument<V>(L, 1, f);
  lua_pushnumber(L, length_of(difference));
  return 1;
}

template <class V>
int lerp(lua_State* L) {
  constexpr Function f = named<V>("lerp");
  // a(1 − t) + bt: exactly b at t = 1, which a + (b − a)t is not.
  push(L, glm::mix(argument<V>(L, 1, f), argument<V>(L, 2, f), argument<double>(L, 3, f)));
  return 1;
}

template <class V>
int minimum(lua_State* L) {
  constexpr Function f = named<V>("min");
  push(L, glm::min(argument<V>(L, 1, f), argument<V>(L, 2, f)));
  return 1;
}

template <class V>
int maximum(lua_State* L) {
  constexpr Function f = named<V>("max");
  push(L, glm::max(argument<V>(L, 1, f), argument<V>(L, 2, f)));
  return 1;
}

template <class V>
int absolute(lua_State* L) {
  push(L, glm::abs(argument<V>(L, 1, named<V>("abs"))));
  return 1;
}

template <class V>
int reflect(lua_State* L) {
  constexpr Function f = named<V>("reflect");
  const V v = argument<V>(L, 1, f), normal = unit(argument<V>(L, 2, f), f, "the normal");
  push(L, v - normal * (2 * glm::dot(normal, v)));
  return 1;
}

/// What the three modules share; the constructor's texts and `cross` are each one's own.
template <class V>
constexpr Entry shared[] = {
    {"__index", "v.x, v.xy, v.bgr, v[1]",
     "A component by name (x y z w, or r g b a) or by number from 1; two to four letters in any "
     "order give a new vector. Components cannot be assigned: build a new vector.",
     guarded<index<V>>},
    {"__newindex", "v.x = 1", "Refused: a vector never changes.",
     guarded<refuse_assignment<KindOf<V>::value>>},
    {"__add", "v + u, v + 2", "The sum, component by component.", guarded<add>},
    {"__sub", "v - u, v - 2", "The difference, component by component.", guarded<subtract>},
    {"__mul", "v * u, v * 2, 2 * v", "The product, component by component.", guarded<multiply>},
    {"__div", "v / u, v / 2, 2 / v", "The quotient, component by component.", guarded<divide>},
    {"__unm", "-v", "The opposite vector.", guarded<negate>},
    {"__eq", "v == u", "Whether all components are equal.", guarded<equal>},
    {"__len", "#v", "The number of components.", guarded<count<V>>},
    {"__tostring", "tostring(v)", "The constructor's call, in as many digits as tell it apart.",
     guarded<to_string<V>>},
    {"dot", "v:dot(u)", "The dot product.", guarded<dot<V>>},
    {"length", "v:length()", "The Euclidean length.", guarded<length<V>>},
    {"normalize", "v:normalize()",
     "The vector of length 1 in the same direction. A vector of length 0 is refused.",
     guarded<normalize<V>>},
    {"distance", "v:distance(u)", "The length of u - v.", guarded<distance<V>>},
    {"lerp", "v:lerp(u, t)", "v (1 - t) + u t: v at t = 0, u at t = 1; t is not clamped.",
     guarded<lerp<V>>},
    {"min", "v:min(u)", "The lesser of each pair of components.", guarded<minimum<V>>},
    {"max", "v:max(u)", "The greater of each pair of components.", guarded<maximum<V>>},
    {"abs", "v:abs()", "The absolute value of each component.", guarded<absolute<V>>},
    {"reflect", "v:reflect(n)",
     "v mirrored in the plane across n, which need not have length 1 but must not have length 0.",
     guarded<reflect<V>>},
};

template <class V, std::size_t n>
constexpr auto with(const Entry (&own)[n]) {
  std::array<Entry, n + std::size(shared<V>)> all{};
  std::ranges::copy(shared<V>, std::ranges::copy(own, all.begin()).out);
  return all;
}

constexpr auto vec2_table = with<glm::dvec2>({
    {"__call", "vec2(x, y), vec2(s), vec2(v), vec2{x, y}",
     "A vector from its components, from one number for all, from the first components of a longer "
     "vector, or from a table.",
     guarded<construct<glm::dvec2>>},
});

constexpr auto vec3_table = with<glm::dvec3>({
    {"__call", "vec3(x, y, z), vec3(s), vec3(vec2, z), vec3(vec4), vec3{x, y, z}",
     "A vector from its components, which shorter vectors may bring, from one number for all, from "
     "the first components of a vec4, or from a table.",
     guarded<construct<glm::dvec3>>},
    {"cross", "v:cross(u)",
     "The cross product: perpendicular to both, right-handed, as long as the parallelogram's area.",
     guarded<cross>},
});

constexpr auto vec4_table = with<glm::dvec4>({
    {"__call", "vec4(x, y, z, w), vec4(s), vec4(vec3, w), vec4{x, y, z, w}",
     "A vector from its components, which shorter vectors may bring, from one number for all, or "
     "from a table. A point has w = 1, a direction w = 0.",
     guarded<construct<glm::dvec4>>},
});

}  // namespace

std::span<const Entry> vec2_entries() { return vec2_table; }
std::span<const Entry> vec3_entries() { return vec3_table; }
std::span<const Entry> vec4_entries() { return vec4_table; }

}  // namespace shadowlab::lua
