// shadow: the subject's geometry, in double precision.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/modules.h"
#include "lua/sampling.h"
#include "lua/truth_pool.h"
#include "lua/volume_pool.h"
#include "shadow/infinite_perspective.h"
#include "shadow/planar.h"

namespace shadowlab::lua {
namespace {

glm::dvec4 plane_argument(lua_State* L, int index, const char* function) {
  return read<glm::dvec4>(
      L, index, fmt::format("argument {} of shadow.{} (a plane)", index, function).c_str());
}

glm::dvec3 vector_argument(lua_State* L, int index, const char* function) {
  if (const auto* homogeneous = test<glm::dvec4>(L, index)) {
    if (homogeneous->w == 0) return glm::dvec3(*homogeneous);
    return glm::dvec3(*homogeneous) / homogeneous->w;
  }
  return read<glm::dvec3>(L, index,
                          fmt::format("argument {} of shadow.{}", index, function).c_str());
}

int planar(lua_State* L) {
  const auto plane = plane_argument(L, 1, "planar");
  const auto light = read_light(L, 2, "argument 2 of shadow.planar");
  push(L, shadow::planar(plane, light.position));
  return 1;
}

int planar_from_origin(lua_State* L) {
  push(L, shadow::planar_from_origin(plane_argument(L, 1, "planar_from_origin")));
  return 1;
}

int planar_from_point(lua_State* L) {
  push(L, shadow::planar_from_point(plane_argument(L, 1, "planar_from_point"),
                                    vector_argument(L, 2, "planar_from_point")));
  return 1;
}

int planar_along(lua_State* L) {
  push(L, shadow::planar_along(plane_argument(L, 1, "planar_along"),
                               vector_argument(L, 2, "planar_along")));
  return 1;
}

int plane_toward(lua_State* L) {
  const auto plane = plane_argument(L, 1, "plane_toward");
  push(L,
       shadow::plane_toward(plane, read_light(L, 2, "argument 2 of shadow.plane_toward").position));
  return 1;
}

int parallelogram(lua_State* L) {
  const auto b = vector_argument(L, 1, "parallelogram"),
             ex = vector_argument(L, 2, "parallelogram"),
             ey = vector_argument(L, 3, "parallelogram");
  push(L, shadow::parallelogram(b, ex, ey,
                                read_light(L, 4, "argument 4 of shadow.parallelogram").position));
  return 1;
}

int bias_matrix(lua_State* L) {
  push(L, glm::dmat4(0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 1));
  return 1;
}

int infinite_perspective(lua_State* L) {
  push(L, shadow::infinite_perspective(
              read<double>(L, 1, "argument 1 of shadow.infinite_perspective (fovy, degrees)"),
              read<double>(L, 2, "argument 2 of shadow.infinite_perspective (aspect)"),
              read<double>(L, 3, "argument 3 of shadow.infinite_perspective (near)")));
  return 1;
}

constexpr Entry functions[] = {
    {"planar", "shadow.planar(plane, light) -> mat4",
     "The projection onto plane (a vec4) from light (a vec4; w = 0: a direction). Refused where "
     "the light is on the plane.",
     guarded<planar>},
    {"planar_from_origin", "shadow.planar_from_origin(plane) -> mat4",
     "The projection onto plane from the world's origin.", guarded<planar_from_origin>},
    {"planar_from_point", "shadow.planar_from_point(plane, point) -> mat4",
     "The projection onto plane from a point.", guarded<planar_from_point>},
    {"planar_along", "shadow.planar_along(plane, direction) -> mat4",
     "The projection onto plane along a direction.", guarded<planar_along>},
    {"plane_toward", "shadow.plane_toward(plane, light) -> vec4",
     "plane with a unit normal and the light on its positive side: what a clip distance takes to "
     "keep the part of a caster that can shadow the plane.",
     guarded<plane_toward>},
    {"parallelogram", "shadow.parallelogram(corner, ex, ey, light) -> mat4",
     "Heckbert and Herf's matrix: the world onto the unit square of a receiver's parallelogram.",
     guarded<parallelogram>},
    {"bias_matrix", "shadow.bias_matrix() -> mat4",
     "[-1, 1]³ to [0, 1]³: clip space to texture space.", guarded<bias_matrix>},
    {"infinite_perspective", "shadow.infinite_perspective(fovy, aspect, near) -> mat4",
     "A perspective whose far plane is at infinity.", guarded<infinite_perspective>},
};

}  // namespace

std::span<const Entry> shadow_functions() { return functions; }

void open_shadow(Stage& stage) {
  lua_State* L = stage.state.raw();
  lua_newtable(L);
  set_functions(L, functions);
  set_functions(L, map_functions());
  set_functions(L, cascade_functions());
  set_functions(L, triangle_grid_functions());
  set_functions(L, volume_functions());
  set_functions(L, silhouette_functions());
  set_functions(L, plan_functions());
  set_functions(L, extrusion_functions());
  set_functions(L, outline_functions());
  set_functions(L, sample_functions());
  set_functions(L, truth_functions());
  refuse_unknown_names(L, -1, "shadow");
  lua_setglobal(L, "shadow");
  open_volume(stage);
  open_extrusion(stage);
  open_outline(stage);
  open_truth(stage);
}

}  // namespace shadowlab::lua
