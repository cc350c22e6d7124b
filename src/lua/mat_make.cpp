#include "lua/mat_make.h"

#include "lua/arguments.h"
#include "lua/degrees.h"

namespace shadowlab::lua {
namespace {

using glm::dmat3, glm::dmat4, glm::dvec3, glm::dvec4;

/// Below this sine of the angle between them, two directions leave no plane but round-off: each is
/// known to about 1e-16, so their cross product would point anywhere within 1e-4 radians.
constexpr double parallel = 1e-12;

/// Rotation around a unit axis: c I + (1 - c) a aᵀ + s [a]× (Rodrigues; the matrix of glRotate).
dmat3 rotation(lua_State* L, const Function& f) {
  const auto [s, c] = sine_cosine(argument<double>(L, 1, f));
  const dvec3 a = unit(vector_argument(L, 2, f), f, "the axis");
  const dmat3 across(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
  return c * dmat3(1) + (1 - c) * glm::outerProduct(a, a) + s * across;
}

/// One number for all three axes, three numbers, or a vec3.
dvec3 factors(lua_State* L, const Function& f) {
  if (lua_gettop(L) == 1 && lua_type(L, 1) == LUA_TNUMBER) return dvec3(lua_tonumber(L, 1));
  return vector_argument(L, 1, f);
}

dmat3 diagonal(const dvec3& d) { return dmat3(d.x, 0, 0, 0, d.y, 0, 0, 0, d.z); }

struct Bounds {
  double left, right, bottom, top, near, far;
};

void require_apart(double a, double b, const char* names, const Function& f) {
  if (!std::isfinite(a) || !std::isfinite(b)) {
    f.refuse(std::string(names) + " must be finite; they are " + text(a) + " and " + text(b));
  }
  if (a == b) f.refuse(std::string(names) + " must differ; both are " + text(a));
}

Bounds bounds(lua_State* L, const Function& f) {
  double b[6];
  for (int i = 0; i < 6; ++i) b[i] = argument<double>(L, i + 1, f);
  require_apart(b[0], b[1], "left and right", f);
  require_apart(b[2], b[3], "bottom and top", f);
  return {b[0], b[1], b[2], b[3], b[4], b[5]};
}

void require_depths(double near, double far, const Function& f) {
  if (!(near > 0)) f.refuse("near must be greater than 0; it is " + text(near));
  if (far > near && std::isinf(far)) {
    f.refuse("far must be finite; for a far plane at infinity use shadow.infinite_perspective");
  }
  if (!(far > near)) {
    f.refuse("far must be greater than near; they are " + text(far) + " and " + text(near));
  }
}

/// glFrustum's matrix (OpenGL 2.1 specification, section 2.11.2).
dmat4 frustum(const Bounds& b) {
  const double width = b.right - b.left, height = b.top - b.bottom, depth = b.far - b.near;
  return {
      dvec4(2 * b.near / width, 0, 0, 0), dvec4(0, 2 * b.near / height, 0, 0),
      dvec4((b.right + b.left) / width, (b.top + b.bottom) / height, -(b.far + b.near) / depth, -1),
      dvec4(0, 0, -2 * b.far * b.near / depth, 0)};
}

}  // namespace

int mat3_rotate(lua_State* L) {
  push(L, rotation(L, {Kind::mat3, "rotate"}));
  return 1;
}

int mat4_rotate(lua_State* L) {
  push(L, dmat4(rotation(L, {Kind::mat4, "rotate"})));
  return 1;
}

int mat3_scale(lua_State* L) {
  push(L, diagonal(factors(L, {Kind::mat3, "scale"})));
  return 1;
}

int mat4_scale(lua_State* L) {
  push(L, dmat4(diagonal(factors(L, {Kind::mat4, "scale"}))));
  return 1;
}

int mat4_translate(lua_State* L) {
  dmat4 m(1);
  m[3] = dvec4(vector_argument(L, 1, {Kind::mat4, "translate"}), 1);
  push(L, m);
  return 1;
}

/// gluLookAt's matrix: the rows are the camera's right, up and backward axes.
int mat4_look_at(lua_State* L) {
  constexpr Function f{Kind::mat4, "look_at"};
  const dvec3 eye = argument<dvec3>(L, 1, f), target = argument<dvec3>(L, 2, f);
  const dvec3 up = unit(argument<dvec3>(L, 3, f), f, "up");
  if (eye == target) f.refuse("the eye and the target are the same point; move one of them");
  const dvec3 forward = unit(target - eye, f, "the way from the eye to the target");
  const dvec3 across = glm::cross(forward, up);
  if (length_of(across) < parallel) {
    f.refuse("up is along the way from the eye to the target; take another up");
  }
  const dvec3 right = unit(across, f, "right");
  const dmat3 axes = glm::transpose(dmat3(right, glm::cross(right, forward), -forward));
  dmat4 m(axes);
  m[3] = dvec4(-(axes * eye), 1);
  push(L, m);
  return 1;
}

int mat4_perspective(lua_State* L) {
  constexpr Function f{Kind::mat4, "perspective"};
  const double fovy = argument<double>(L, 1, f), aspect = argument<double>(L, 2, f);
  const double near = argument<double>(L, 3, f), far = argument<double>(L, 4, f);
  if (!(fovy > 0 && fovy < 180)) {
    f.refuse("the field of view must lie between 0 and 180 degrees; it is " + text(fovy));
  }
  if (!(aspect > 0) || std::isinf(aspect)) {
    f.refuse("the aspect, width / height, must be greater than 0 and finite; it is " +
             text(aspect));
  }
  require_depths(near, far, f);
  // gluPerspective's matrix: the frustum's, with the cotangent for near / (height / 2).
  const auto [s, c] = sine_cosine(fovy / 2);
  dmat4 m = frustum({-1, 1, -1, 1, near, far});
  m[0][0] = c / s / aspect;
  m[1][1] = c / s;
  push(L, m);
  return 1;
}

int mat4_frustum(lua_State* L) {
  constexpr Function f{Kind::mat4, "frustum"};
  const Bounds b = bounds(L, f);
  require_depths(b.near, b.far, f);
  push(L, frustum(b));
  return 1;
}

/// glOrtho's matrix (OpenGL 2.1 specification, section 2.11.2).
int mat4_ortho(lua_State* L) {
  constexpr Function f{Kind::mat4, "ortho"};
  const Bounds b = bounds(L, f);
  require_apart(b.near, b.far, "near and far", f);
  const double width = b.right - b.left, height = b.top - b.bottom, depth = b.far - b.near;
  dmat4 m(1);
  m[0][0] = 2 / width;
  m[1][1] = 2 / height;
  m[2][2] = -2 / depth;
  m[3] = dvec4(-(b.right + b.left) / width, -(b.top + b.bottom) / height, -(b.far + b.near) / depth,
               1);
  push(L, m);
  return 1;
}

}  // namespace shadowlab::lua
