// quat in Lua.
#include "lua/arguments.h"
#include "lua/degrees.h"
#include "lua/guard.h"
#include "lua/operators.h"

namespace shadowlab::lua {
namespace {

using glm::dquat;

constexpr Function named(const char* name) { return {Kind::quat, name}; }

int construct(lua_State* L) {
  if (lua_gettop(L) == 2 && lua_type(L, 2) == LUA_TTABLE) {
    push(L, read<dquat>(L, 2, "argument 1 of quat"));
    return 1;
  }
  double wxyz[4];
  gather(L, 2, "quat", wxyz);
  push(L, dquat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]));
  return 1;
}

int index(lua_State* L) {
  const dquat& q = self<dquat>(L);
  std::size_t length = 0;
  const char* field = lua_type(L, 2) == LUA_TSTRING ? lua_tolstring(L, 2, &length) : "";
  if (length != 1) return index_method(L, Kind::quat);
  switch (field[0]) {
    case 'w':
      lua_pushnumber(L, q.w);
      return 1;
    case 'x':
      lua_pushnumber(L, q.x);
      return 1;
    case 'y':
      lua_pushnumber(L, q.y);
      return 1;
    case 'z':
      lua_pushnumber(L, q.z);
      return 1;
    default:
      return index_method(L, Kind::quat);
  }
}

int count(lua_State* L) {
  lua_pushinteger(L, 4);
  return 1;
}

int to_string(lua_State* L) {
  const dquat q = argument<dquat>(L, 1, named("__tostring"));
  const double wxyz[4] = {q.w, q.x, q.y, q.z};
  lua_pushstring(L, call_text("quat", wxyz).c_str());
  return 1;
}

int identity(lua_State* L) {
  push(L, dquat(1, 0, 0, 0));
  return 1;
}

int axis_angle(lua_State* L) {
  constexpr Function f = named("axis_angle");
  const double half = argument<double>(L, 1, f) / 2;
  const glm::dvec3 axis = unit(vector_argument(L, 2, f), f, "the axis");
  const auto [sine, cosine] = sine_cosine(half);
  push(L, dquat(cosine, sine * axis));
  return 1;
}

/// The quaternion of length 1: the only ones that are rotations.
dquat rotation(lua_State* L, int argument_index, const Function& f) {
  return unit(argument<dquat>(L, argument_index, f), f, "the quaternion");
}

int to_mat3(lua_State* L) {
  push(L, glm::mat3_cast(rotation(L, 1, named("mat3"))));
  return 1;
}

int to_mat4(lua_State* L) {
  push(L, glm::mat4_cast(rotation(L, 1, named("mat4"))));
  return 1;
}

int slerp(lua_State* L) {
  constexpr Function f = named("slerp");
  const dquat from = rotation(L, 1, f), to = rotation(L, 2, f);
  push(L, glm::slerp(from, to, argument<double>(L, 3, f)));
  return 1;
}

int normalize(lua_State* L) {
  push(L, rotation(L, 1, named("normalize")));
  return 1;
}

int conjugate(lua_State* L) {
  push(L, glm::conjugate(argument<dquat>(L, 1, named("conjugate"))));
  return 1;
}

int inverse(lua_State* L) {
  constexpr Function f = named("inverse");
  const dquat q = argument<dquat>(L, 1, f);
  // Divided by the length twice, so that its square neither overflows nor underflows.
  push(L, glm::conjugate(unit(q, f, "the quaternion")) / length_of(q));
  return 1;
}

int dot(lua_State* L) {
  constexpr Function f = named("dot");
  lua_pushnumber(L, glm::dot(argument<dquat>(L, 1, f), argument<dquat>(L, 2, f)));
  return 1;
}

int length(lua_State* L) {
  lua_pushnumber(L, length_of(argument<dquat>(L, 1, named("length"))));
  return 1;
}

constexpr Entry table[] = {
    {"__call", "quat(w, x, y, z), quat{w, x, y, z}",
     "A quaternion: w the real part, x y z the imaginary one.", guarded<construct>},
    {"__index", "q.w, q.x, q.y, q.z", "A component. Components cannot be assigned.",
     guarded<index>},
    {"__newindex", "q.w = 1", "Refused: a quaternion never changes.",
     guarded<refuse_assignment<Kind::quat>>},
    {"__add", "q + p", "The sum, component by component.", guarded<add>},
    {"__sub", "q - p", "The difference, component by component.", guarded<subtract>},
    {"__mul", "q * p, q * v, q * 2",
     "The rotation p followed by q; the vec3 v rotated by q, which must have length 1; or each "
     "component multiplied by a number.",
     guarded<multiply>},
    {"__div", "q / 2", "Each component divided by a number.", guarded<divide>},
    {"__unm", "-q", "The opposite quaternion, which is the same rotation.", guarded<negate>},
    {"__eq", "q == p", "Whether all components are equal.", guarded<equal>},
    {"__len", "#q", "4.", guarded<count>},
    {"__tostring", "tostring(q)", "The constructor's call, in as many digits as tell it apart.",
     guarded<to_string>},
    {"identity", "quat.identity()", "No rotation: quat(1, 0, 0, 0).", guarded<identity>},
    {"axis_angle", "quat.axis_angle(degrees, axis), quat.axis_angle(degrees, x, y, z)",
     "The rotation by an angle in degrees around an axis of any length but 0, counter-clockwise "
     "where the axis points at the viewer.",
     guarded<axis_angle>},
    {"mat3", "q:mat3()", "The rotation as a mat3. A quaternion of length 0 is refused.",
     guarded<to_mat3>},
    {"mat4", "q:mat4()", "The rotation as a mat4. A quaternion of length 0 is refused.",
     guarded<to_mat4>},
    {"slerp", "q:slerp(p, t)",
     "The rotation a fraction t of the shorter way from q to p, at constant speed (spherical "
     "linear interpolation). Quaternions of length 0 are refused.",
     guarded<slerp>},
    {"normalize", "q:normalize()", "The quaternion of length 1. One of length 0 is refused.",
     guarded<normalize>},
    {"conjugate", "q:conjugate()", "quat(q.w, -q.x, -q.y, -q.z).", guarded<conjugate>},
    {"inverse", "q:inverse()", "The quaternion that undoes q. One of length 0 is refused.",
     guarded<inverse>},
    {"dot", "q:dot(p)", "The dot product of the four components.", guarded<dot>},
    {"length", "q:length()", "The length of the four components.", guarded<length>},
};

}  // namespace

std::span<const Entry> quat_entries() { return table; }

}  // namespace shadowlab::lua
