// shadow.*: the geometry of shadow maps.
#include <array>
#include <span>

#include "lua/map_arguments.h"
#include "lua/modules.h"
#include "lua/planned.h"
#include "shadow/light_view.h"
#include "shadow/map_bias.h"

namespace shadowlab::lua {
namespace {

std::vector<std::size_t> read_casters(lua_State* L, const SceneBox& scene) {
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError("casters is a table of the scene's objects; it is " + describe(L, -1));
  std::vector<std::size_t> casters;
  const int table = lua_gettop(L);
  for (lua_Integer i = 1; lua_rawgeti(L, table, i) != LUA_TNIL; ++i) {
    const ObjectBox& box = read_box<ObjectBox>(L, -1, fmt::format("casters[{}]", i));
    if (box.scene != scene)
      throw InputError(fmt::format("casters[{}] is no object of this scene", i));
    casters.push_back(box.index);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return casters;
}

struct FittedTo {
  shadow::MapContent content;
  bool in_view = true;
  double radius = 0;  // of the light
};

// The last is of one view alone: cube faces have the whole of their angle anyway.
constexpr std::array<std::string_view, 3> view_options{"fit", "casters", "radius"};
constexpr auto cube_options = std::span(view_options).first<2>();

// { fit = "view" | "scene", casters = {object, …}, radius = metres } at `index`.
FittedTo read_fit(lua_State* L, int index, const char* function, const SceneBox& scene,
                  std::span<const std::string_view> names) {
  bool in_view = true;
  double radius = 0;
  std::optional<std::vector<std::size_t>> casters;
  each_option(L, index, function, names, [&](std::string_view key) {
    if (key == "fit") in_view = is_first_of(L, key, "view", "scene");
    if (key == "casters") casters = read_casters(L, scene);
    if (key == "radius") radius = number_option(L, key);
  });
  auto content = in_view ? shadow::content_in_view(*scene, scene->camera, Stage::of(L).aspect())
                         : shadow::whole_content(*scene);
  content.casters = std::move(casters);
  return {std::move(content), in_view, radius};
}

// ---- the functions

int light_view(lua_State* L) {
  const auto light = light_argument(L, 1, "light_view");
  const SceneBox& scene = scene_argument(L, 2, "light_view");
  const FittedTo fit = read_fit(L, 3, "light_view", scene, view_options);
  auto view = shadow::light_view(light, *scene, fit.content);
  double reach = 0;
  if (fit.radius != 0) {
    view = shadow::with_room(view, fit.radius);
    reach = shadow::edge_reach(view, fit.radius);
  }
  // A map of the whole scene may be kept for what another camera sees.
  if (const auto& planned = Stage::of(L).planned; planned && fit.in_view)
    planned->add_map({scene, light, view.view, view.projection, {}, reach});
  push(L, view.view);
  push(L, view.projection);
  lua_pushnumber(L, view.near);
  lua_pushnumber(L, view.far);
  return 4;
}

int map_bias(lua_State* L) {
  const auto projection = read<glm::dmat4>(L, 1, "argument 1 of shadow.map_bias (a projection)");
  const double size = read<double>(L, 2, "argument 2 of shadow.map_bias (the map's size)");
  const double filter =
      lua_isnoneornil(L, 3) ? 1 : read<double>(L, 3, "argument 3 of shadow.map_bias (the filter)");
  const auto bias = shadow::map_bias(projection, size, filter);
  Stage& stage = Stage::of(L);
  const bool read = !stage.planned || stage.planned->add_lookup(projection, static_cast<int>(size),
                                                                filter, stage.picture_size());
  lua_newtable(L);
  lua_pushboolean(L, read);
  lua_setfield(L, -2, "read");
  set_number(L, "factor", bias.factor);
  set_number(L, "units", bias.units);
  set_number(L, "normal_offset", bias.normal_offset);
  set_number(L, "texel", bias.texel);
  set_number(L, "reach", bias.reach);
  return 1;
}

int cube_faces(lua_State* L) {
  const glm::dvec4 light = light_argument(L, 1, "cube_faces");
  const auto faces =
      shadow::cube_faces(light, read<double>(L, 2, "argument 2 of shadow.cube_faces"),
                         read<double>(L, 3, "argument 3 of shadow.cube_faces"));
  if (const auto& planned = Stage::of(L).planned) planned->add_cube_faces(light, faces);
  lua_newtable(L);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    push_view(L, faces[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int cube_range(lua_State* L) {
  const auto light = light_argument(L, 1, "cube_range");
  const SceneBox& scene = scene_argument(L, 2, "cube_range");
  const FittedTo fit = read_fit(L, 3, "cube_range", scene, cube_options);
  if (const auto& planned = Stage::of(L).planned) planned->add_cube(scene, light, fit.in_view);
  const auto range = shadow::cube_range(light, *scene, fit.content);
  lua_pushnumber(L, range.near);
  lua_pushnumber(L, range.far);
  return 2;
}

int faces_needed(lua_State* L) {
  const auto light = light_argument(L, 1, "faces_needed");
  const SceneBox& scene = scene_argument(L, 2, "faces_needed");
  const auto needed = shadow::faces_needed(
      light, *scene, read_fit(L, 3, "faces_needed", scene, cube_options).content);
  lua_newtable(L);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    lua_pushboolean(L, needed[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

constexpr Entry functions[] = {
    {"light_view",
     "shadow.light_view(light, scene, {fit = \"view\"|\"scene\", casters = {object, …}, radius = "
     "}) "
     "-> view, projection, near, far",
     "The light's view and projection for a shadow map, fitted to the casters that can shadow what "
     "the camera sees (or, fit = \"scene\", anything), and to those shadows alone: what is outside "
     "of the map or behind the light is lit. With a point light's radius, in metres, there is room "
     "around them for what its edge alone sees. Orthographic for a light at infinity. Refused "
     "where a "
     "point light is among its casters, so that one frustum cannot hold them.",
     guarded<light_view>},
    {"map_bias",
     "shadow.map_bias(projection, size, filter) -> {factor, units, reach, normal_offset, texel, "
     "read}",
     "The least bias without acne for a map of size × size texels drawn with this projection and "
     "read by a filter so many texels wide (1 unless given): factor and units for "
     "gl.PolygonOffset and reach, how far a lookup is from what it reads, over the map: a receiver "
     "takes off as much as its own plane climbs on that way; or normal_offset · sin θ along the "
     "receiver's normal, θ being the angle from normal to light, and texel the side of a texel; "
     "both "
     "in metres, under a perspective for each metre along its axis. read: whether anybody reads "
     "such "
     "a map, which under run --plan is so only where a caster may shadow what is seen; it need not "
     "be made otherwise.",
     guarded<map_bias>},
    {"cube_faces", "shadow.cube_faces(light, near, far) -> { {view = , projection = }, … }",
     "Six views of 90 degrees from a point light, in the order and with the axes of "
     "gl.TEXTURE_CUBE_MAP_POSITIVE_X, …",
     guarded<cube_faces>},
    {"cube_range", "shadow.cube_range(light, scene, {fit = }) -> near, far",
     "The near and far of cube faces: before the nearest caster, behind the farthest receiver.",
     guarded<cube_range>},
    {"faces_needed", "shadow.faces_needed(light, scene, {fit = }) -> {boolean, …}",
     "For each of the six faces, whether it can hold a shadow that the camera sees.",
     guarded<faces_needed>},
};

}  // namespace

std::span<const Entry> map_functions() { return functions; }

}  // namespace shadowlab::lua
