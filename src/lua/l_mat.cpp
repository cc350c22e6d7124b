// mat3 and mat4 in Lua: their elements, their algebra, and the tables of both modules.
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "lua/arguments.h"
#include "lua/guard.h"
#include "lua/mat_make.h"
#include "lua/operators.h"

namespace shadowlab::lua {
namespace {

using glm::dmat3, glm::dmat4, glm::dvec3, glm::dvec4;

template <class M>
constexpr int size = M::length();
template <class M>
constexpr Function named(const char* name) {
  return {KindOf<M>::value, name};
}

/// The matrix whose elements the arguments from `first` on bring, column by column.
template <class M>
M columns(lua_State* L, int first, const char* constructor) {
  M m;
  gather(L, first, constructor, {glm::value_ptr(m), sizeof(M) / sizeof(double)});
  return m;
}

template <class M>
int construct(lua_State* L) {
  const char* constructor = name(KindOf<M>::value);
  if (lua_gettop(L) != 2) {
    push(L, columns<M>(L, 2, constructor));
  } else if (lua_type(L, 2) == LUA_TNUMBER) {
    push(L, M(lua_tonumber(L, 2)));
  } else if (const auto* m3 = test<dmat3>(L, 2)) {
    push(L, M(*m3));
  } else if (const auto* m4 = test<dmat4>(L, 2)) {
    push(L, M(*m4));
  } else {
    push(L, read<M>(L, 2, ("argument 1 of " + std::string(constructor)).c_str()));
  }
  return 1;
}

template <class M>
int rows(lua_State* L) {
  const std::string constructor = named<M>("rows").text();
  push(L, glm::transpose(columns<M>(L, 1, constructor.c_str())));
  return 1;
}

template <class M>
int identity(lua_State* L) {
  push(L, M(1));
  return 1;
}

template <class M>
int index(lua_State* L) {
  const M& m = self<M>(L);
  if (lua_type(L, 2) != LUA_TNUMBER) return index_method(L, KindOf<M>::value);
  const lua_Integer i = lua_tointeger(L, 2);
  if (i < 1 || i > size<M>) {
    throw InputError("a " + std::string(name(KindOf<M>::value)) + " has columns 1 to " +
                     std::to_string(size<M>) + "; it has no " + field_name(L, 2));
  }
  push(L, m[static_cast<glm::length_t>(i - 1)]);
  return 1;
}

/// Argument 2: the number of a row or column, which Lua counts from 1 and GLM from 0.
template <class M>
glm::length_t place(lua_State* L, const Function& f) {
  const double i = argument<double>(L, 2, f);
  for (glm::length_t k = 0; k < size<M>; ++k) {
    if (i == k + 1) return k;
  }
  f.refuse("a " + std::string(name(KindOf<M>::value)) + " has " + f.name + "s 1 to " +
           std::to_string(size<M>) + "; there is no " + f.name + " " + text(i));
}

template <class M>
int column(lua_State* L) {
  constexpr Function f = named<M>("column");
  const M m = argument<M>(L, 1, f);
  push(L, m[place<M>(L, f)]);
  return 1;
}

template <class M>
int row(lua_State* L) {
  constexpr Function f = named<M>("row");
  const M m = glm::transpose(argument<M>(L, 1, f));
  push(L, m[place<M>(L, f)]);
  return 1;
}

template <class M>
int count(lua_State* L) {
  lua_pushinteger(L, size<M>);
  return 1;
}

/// The call of `rows` that makes the matrix, a row a line, the columns aligned.
template <class M>
int to_string(lua_State* L) {
  const M m = argument<M>(L, 1, named<M>("__tostring"));
  std::string call = named<M>("rows").text() + "(";
  for (glm::length_t r = 0; r < size<M>; ++r) {
    for (glm::length_t c = 0; c < size<M>; ++c) {
      std::size_t width = 0;
      for (const double number :
           numbers(m).subspan(static_cast<std::size_t>(c * size<M>), size<M>)) {
        width = std::max(width, text(number).size());
      }
      const std::string number = text(m[c][r]);
      call += (c == 0 ? (r == 0 ? "\n  " : ",\n  ") : ", ");
      call += std::string(width - number.size(), ' ') + number;
    }
  }
  lua_pushstring(L, (call + ")").c_str());
  return 1;
}

/// The permanent of |m|: the determinant's terms all added up, which bounds its round-off. The
/// smaller one is expanded along a column, the larger one by Laplace's pairs of columns.
double permanent(const dmat3& m) {
  const auto a = [&](int c, int r) { return std::fabs(m[c][r]); };
  return a(0, 0) * (a(1, 1) * a(2, 2) + a(1, 2) * a(2, 1)) +
         a(0, 1) * (a(1, 0) * a(2, 2) + a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) + a(1, 1) * a(2, 0));
}

double permanent(const dmat4& m) {
  const auto pair = [&](int c, int d, int r) {
    return std::fabs(m[c][r] * m[d][r + 1]) + std::fabs(m[d][r] * m[c][r + 1]);
  };
  return pair(0, 1, 0) * pair(2, 3, 2) + pair(0, 2, 0) * pair(1, 3, 2) +
         pair(0, 3, 0) * pair(1, 2, 2) + pair(1, 2, 0) * pair(0, 3, 2) +
         pair(1, 3, 0) * pair(0, 2, 2) + pair(2, 3, 0) * pair(0, 1, 2);
}

template <class M>
int inverse(lua_State* L) {
  constexpr Function f = named<M>("inverse");
  const M m = argument<M>(L, 1, f);
  const double determinant = glm::determinant(m), terms = permanent(m);
  if (!std::isfinite(terms)) f.refuse("the matrix holds numbers that are not finite or too large");
  // Each term of the determinant carries at most 12 roundings of half an epsilon: 4 from its
  // elements, 8 from products and sums. What is smaller than that may as well be 0.
  if (std::fabs(determinant) <= 8 * std::numeric_limits<double>::epsilon() * terms) {
    f.refuse("the matrix is singular (its determinant is 0 up to round-off), so it has no inverse");
  }
  push(L, glm::inverse(m));
  return 1;
}

template <class M>
int transpose(lua_State* L) {
  push(L, glm::transpose(argument<M>(L, 1, named<M>("transpose"))));
  return 1;
}

template <class M>
int determinant(lua_State* L) {
  lua_pushnumber(L, glm::determinant(argument<M>(L, 1, named<M>("determinant"))));
  return 1;
}

int upper_left(lua_State* L) {
  push(L, dmat3(argument<dmat4>(L, 1, named<dmat4>("mat3"))));
  return 1;
}

int transform_point(lua_State* L) {
  constexpr Function f = named<dmat4>("transform_point");
  const dvec4 p = argument<dmat4>(L, 1, f) * dvec4(argument<dvec3>(L, 2, f), 1);
  if (p.w == 0) {
    f.refuse("the point goes to infinity (its w is 0); m * vec4(v, 1) gives its direction there");
  }
  push(L, dvec3(p) / p.w);
  return 1;
}

int transform_direction(lua_State* L) {
  constexpr Function f = named<dmat4>("transform_direction");
  push(L, dmat3(argument<dmat4>(L, 1, f)) * argument<dvec3>(L, 2, f));
  return 1;
}

/// What both modules share.
template <class M>
constexpr Entry shared[] = {
    {"__index", "m[column][row], m[column]",
     "An element, or a column as a vector, counted from 1. Elements cannot be assigned.",
     guarded<index<M>>},
    {"__newindex", "m[1] = v", "Refused: a matrix never changes.",
     guarded<refuse_assignment<KindOf<M>::value>>},
    {"__add", "m + n", "The sum, element by element.", guarded<add>},
    {"__sub", "m - n", "The difference, element by element.", guarded<subtract>},
    {"__mul", "m * v, m * n, m * 2, 2 * m",
     "The vector v transformed; the matrix that does n and then m; or each element multiplied by a "
     "number.",
     guarded<multiply>},
    {"__div", "m / 2", "Each element divided by a number.", guarded<divide>},
    {"__unm", "-m", "The opposite matrix.", guarded<negate>},
    {"__eq", "m == n", "Whether all elements are equal.", guarded<equal>},
    {"__len", "#m", "The number of columns.", guarded<count<M>>},
    {"__tostring", "tostring(m)",
     "The matrix row by row, as it is written on paper, in as many digits as tell it apart.",
     guarded<to_string<M>>},
    {"identity", size<M> == 3 ? "mat3.identity()" : "mat4.identity()",
     "The matrix that changes nothing.", guarded<identity<M>>},
    {"rows", size<M> == 3 ? "mat3.rows(...)" : "mat4.rows(...)",
     "A matrix from its elements row by row, as it is written on paper; or from its rows as "
     "vectors.",
     guarded<rows<M>>},
    {"column", "m:column(i)", "Column i as a vector, counted from 1.", guarded<column<M>>},
    {"row", "m:row(i)", "Row i as a vector, counted from 1.", guarded<row<M>>},
    {"inverse", "m:inverse()", "The inverse. A singular matrix is refused.", guarded<inverse<M>>},
    {"transpose", "m:transpose()", "Rows and columns exchanged.", guarded<transpose<M>>},
    {"determinant", "m:determinant()", "The determinant.", guarded<determinant<M>>},
};

template <class M, std::size_t n>
constexpr auto with(const Entry (&own)[n]) {
  std::array<Entry, n + std::size(shared<M>)> all{};
  std::ranges::copy(shared<M>, std::ranges::copy(own, all.begin()).out);
  return all;
}

constexpr auto mat3_table = with<dmat3>({
    {"__call", "mat3(a11, a21, a31, ...), mat3(c1, c2, c3), mat3(s), mat3(mat4), mat3{...}",
     "A matrix from its 9 elements column by column, as GL stores them; from its columns; with s "
     "on the diagonal; or the upper left part of a mat4.",
     guarded<construct<dmat3>>},
    {"rotate", "mat3.rotate(degrees, axis), mat3.rotate(degrees, x, y, z)",
     "The rotation by an angle in degrees around an axis of any length but 0, counter-clockwise "
     "where the axis points at the viewer.",
     guarded<mat3_rotate>},
    {"scale", "mat3.scale(s), mat3.scale(x, y, z), mat3.scale(v)",
     "The scaling by one factor, or by one for each axis.", guarded<mat3_scale>},
});

constexpr auto mat4_table = with<dmat4>({
    {"__call",
     "mat4(a11, a21, a31, a41, ...), mat4(c1, c2, c3, c4), mat4(s), mat4(mat3), mat4{...}",
     "A matrix from its 16 elements column by column, as GL stores them; from its columns; with s "
     "on the diagonal; or a mat3 that leaves w alone.",
     guarded<construct<dmat4>>},
    {"look_at", "mat4.look_at(eye, target, up)",
     "World to eye space, as gluLookAt: the camera at eye looks down its own -z at target. Refused "
     "where eye and target are one point, or up is along the view.",
     guarded<mat4_look_at>},
    {"perspective", "mat4.perspective(fovy, aspect, near, far)",
     "Eye to clip space, as gluPerspective: fovy is the vertical field of view in degrees, aspect "
     "is width / height, and 0 < near < far are distances. Depth goes to [-1, 1].",
     guarded<mat4_perspective>},
    {"frustum", "mat4.frustum(left, right, bottom, top, near, far)",
     "Eye to clip space, as glFrustum: the window on the near plane. Depth goes to [-1, 1].",
     guarded<mat4_frustum>},
    {"ortho", "mat4.ortho(left, right, bottom, top, near, far)",
     "Eye to clip space, as glOrtho: a box to the cube [-1, 1].", guarded<mat4_ortho>},
    {"translate", "mat4.translate(x, y, z), mat4.translate(v)", "The translation by a vector.",
     guarded<mat4_translate>},
    {"rotate", "mat4.rotate(degrees, axis), mat4.rotate(degrees, x, y, z)",
     "The rotation by an angle in degrees around an axis of any length but 0, counter-clockwise "
     "where the axis points at the viewer.",
     guarded<mat4_rotate>},
    {"scale", "mat4.scale(s), mat4.scale(x, y, z), mat4.scale(v)",
     "The scaling by one factor, or by one for each axis.", guarded<mat4_scale>},
    {"mat3", "m:mat3()", "The upper left 3×3 part: what the matrix does to directions.",
     guarded<upper_left>},
    {"transform_point", "m:transform_point(v)",
     "The vec3 that m * vec4(v, 1) stands for: its x, y, z divided by its w. A point that goes to "
     "infinity (w = 0) is refused.",
     guarded<transform_point>},
    {"transform_direction", "m:transform_direction(v)",
     "The x, y, z of m * vec4(v, 0): translation has no effect.", guarded<transform_direction>},
});

}  // namespace

std::span<const Entry> mat3_entries() { return mat3_table; }
std::span<const Entry> mat4_entries() { return mat4_table; }

}  // namespace shadowlab::lua
