#include "lua/operators.h"

#include <variant>

#include "lua/arguments.h"

namespace shadowlab::lua {
namespace {

using Operand =
    std::variant<double, glm::dvec2, glm::dvec3, glm::dvec4, glm::dmat3, glm::dmat4, glm::dquat>;

template <class T, class... Ts>
constexpr bool is_one_of = (std::is_same_v<T, Ts> || ...);
template <class T>
constexpr bool is_number = std::is_same_v<T, double>;
template <class T>
constexpr bool is_vector = is_one_of<T, glm::dvec2, glm::dvec3, glm::dvec4>;
template <class T>
constexpr bool is_matrix = is_one_of<T, glm::dmat3, glm::dmat4>;
template <class T>
constexpr bool is_quaternion = is_one_of<T, glm::dquat>;
template <class A, class B>
constexpr bool is_vector_with_number = (is_vector<A> && is_number<B>) ||
                                       (is_number<A> && is_vector<B>);
template <class A, class B>
constexpr bool are_same = std::is_same_v<A, B> && !is_number<A>;

// Each operator: its words in a refusal, the pairs that have a meaning, and the meaning. As in
// GLSL, a number meets each component of a vector; unlike GLSL, a vector never stands left of a
// matrix.
struct Add {
  static constexpr const char* verb = "add";
  static constexpr const char* between = " and ";
  template <class A, class B>
  static constexpr bool defined = are_same<A, B> || is_vector_with_number<A, B>;
  template <class A, class B>
  static auto apply(const A& a, const B& b) {
    return a + b;
  }
};

struct Subtract {
  static constexpr const char* verb = "subtract";
  static constexpr const char* between = " and ";
  template <class A, class B>
  static constexpr bool defined = are_same<A, B> || is_vector_with_number<A, B>;
  template <class A, class B>
  static auto apply(const A& a, const B& b) {
    return a - b;
  }
};

struct Multiply {
  static constexpr const char* verb = "multiply";
  static constexpr const char* between = " by ";
  template <class A, class B>
  static constexpr bool defined = are_same<A, B> || (is_number<A> != is_number<B>) ||
                                  (is_one_of<A, glm::dmat3, glm::dquat> &&
                                   is_one_of<B, glm::dvec3>) ||
                                  (is_one_of<A, glm::dmat4> && is_one_of<B, glm::dvec4>);
  template <class A, class B>
  static auto apply(const A& a, const B& b) {
    return a * b;
  }
};

struct Divide {
  static constexpr const char* verb = "divide";
  static constexpr const char* between = " by ";
  template <class A, class B>
  static constexpr bool defined = (is_vector<A> && std::is_same_v<A, B>) ||
                                  (!is_number<A> && is_number<B>) || (is_number<A> && is_vector<B>);
  template <class A, class B>
  static auto apply(const A& a, const B& b) {
    return a / b;
  }
};

std::optional<Operand> operand(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return lua_tonumber(L, index);
  const auto kind = kind_of(L, index);
  if (!kind) return std::nullopt;
  const void* value = lua_touserdata(L, index);
  switch (*kind) {
    case Kind::vec2:
      return *static_cast<const glm::dvec2*>(value);
    case Kind::vec3:
      return *static_cast<const glm::dvec3*>(value);
    case Kind::vec4:
      return *static_cast<const glm::dvec4*>(value);
    case Kind::mat3:
      return *static_cast<const glm::dmat3*>(value);
    case Kind::mat4:
      return *static_cast<const glm::dmat4*>(value);
    case Kind::quat:
      return *static_cast<const glm::dquat*>(value);
  }
  return std::nullopt;
}

/// What to write instead of a pair that has no meaning; empty where nothing is likely meant.
template <class Op, class A, class B>
constexpr const char* advice() {
  constexpr bool multiplies = std::is_same_v<Op, Multiply>;
  if constexpr (multiplies && is_one_of<A, glm::dmat4> && is_one_of<B, glm::dvec3>) {
    return "; use m * vec4(v, 1), m:transform_point(v) or m:transform_direction(v)";
  } else if constexpr (multiplies && is_vector<A> && (is_matrix<B> || is_quaternion<B>)) {
    return "; write the vector on the right: m * v";
  } else if constexpr (multiplies && is_matrix<A> && is_vector<B>) {
    return "; the vector needs as many components as the matrix has columns";
  } else if constexpr (multiplies && is_matrix<A> && is_matrix<B>) {
    return "; m:mat3() and mat4(m) turn one into the other";
  } else if constexpr (std::is_same_v<Op, Divide> && is_matrix<B>) {
    return "; multiply by m:inverse()";
  } else if constexpr (std::is_same_v<Op, Divide> && is_quaternion<B>) {
    return "; multiply by q:inverse()";
  } else {
    return "";
  }
}

template <class Op>
[[noreturn]] void refuse(lua_State* L, const char* tail) {
  throw InputError(std::string("cannot ") + Op::verb + " " + describe(L, 1) + Op::between +
                   describe(L, 2) + tail);
}

template <class Op>
int apply(lua_State* L) {
  const auto a = operand(L, 1);
  const auto b = operand(L, 2);
  if (!a || !b) refuse<Op>(L, "");
  std::visit(
      [&]<class A, class B>(const A& left, const B& right) {
        if constexpr (Op::template defined<A, B>) {
          push(L, Op::apply(left, right));
        } else {
          refuse<Op>(L, advice<Op, A, B>());
        }
      },
      *a, *b);
  return 1;
}

}  // namespace

int add(lua_State* L) { return apply<Add>(L); }
int subtract(lua_State* L) { return apply<Subtract>(L); }
int multiply(lua_State* L) { return apply<Multiply>(L); }
int divide(lua_State* L) { return apply<Divide>(L); }

int negate(lua_State* L) {
  const auto a = operand(L, 1);
  if (!a) throw InputError("cannot negate " + describe(L, 1));
  std::visit(
      [&]<class A>(const A& value) {
        if constexpr (is_number<A>) {
          lua_pushnumber(L, -value);
        } else {
          push(L, -value);
        }
      },
      *a);
  return 1;
}

int equal(lua_State* L) {
  const auto a = operand(L, 1);
  const auto b = operand(L, 2);
  const auto same = []<class A, class B>(const A& left, const B& right) {
    if constexpr (std::is_same_v<A, B>) return left == right;
    return false;
  };
  lua_pushboolean(L, a && b && std::visit(same, *a, *b));
  return 1;
}

}  // namespace shadowlab::lua
