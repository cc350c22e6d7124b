// shadow.*: the geometry of shadow maps.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/modules.h"
#include "lua/planned.h"
#include "shadow/cascades.h"
#include "shadow/light_view.h"
#include "shadow/map_bias.h"

namespace shadowlab::lua {
namespace {

// ---- options: a table of known names

template <class Visit>
void each_option(lua_State* L, int index, const char* function,
                 std::span<const std::string_view> names, Visit visit) {
  if (lua_isnoneornil(L, index)) return;
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError(fmt::format("argument {} of shadow.{} must be a table of options; it is {}",
                                 index, function, describe(L, index)));
  }
  lua_pushnil(L);
  while (lua_next(L, index)) {
    const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(names.begin(), names.end(), key) == names.end()) {
      throw InputError(
          fmt::format("shadow.{} has no option {}{}", function, key, did_you_mean(key, names)));
    }
    visit(std::string_view(key));
    lua_pop(L, 1);
  }
}

double number_option(lua_State* L, std::string_view name) {
  return read<double>(L, lua_gettop(L), std::string(name).c_str());
}

// One of two words, the first or not.
bool is_first_of(lua_State* L, std::string_view option, std::string_view first,
                 std::string_view second) {
  const std::string_view word = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  if (word == first || word == second) return word == first;
  throw InputError(
      fmt::format("{} is \"{}\" or \"{}\"; it is {}", option, first, second, describe(L, -1)));
}

glm::dvec4 light_argument(lua_State* L, int index, const char* function) {
  return read_light(L, index, fmt::format("argument {} of shadow.{} (the light)", index, function))
      .position;
}

SceneBox& scene_argument(lua_State* L, int index, const char* function) {
  return read_box<SceneBox>(
      L, index, fmt::format("argument {} of shadow.{} (the scene)", index, function).c_str());
}

int integer_argument(lua_State* L, int index, const char* function, int least, int most) {
  const double value =
      read<double>(L, index, fmt::format("argument {} of shadow.{}", index, function).c_str());
  if (value != std::floor(value) || value < least || value > most) {
    throw InputError(fmt::format("argument {} of shadow.{} must be a whole number from {} to {}",
                                 index, function, least, most));
  }
  return static_cast<int>(value);
}

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
};

// { fit = "view" | "scene", casters = {object, …} } at `index`.
FittedTo read_fit(lua_State* L, int index, const char* function, const SceneBox& scene) {
  static constexpr std::string_view names[] = {"fit", "casters"};
  bool in_view = true;
  std::optional<std::vector<std::size_t>> casters;
  each_option(L, index, function, names, [&](std::string_view key) {
    if (key == "fit") in_view = is_first_of(L, key, "view", "scene");
    if (key == "casters") casters = read_casters(L, scene);
  });
  auto content = in_view ? shadow::content_in_view(*scene, scene->camera, Stage::of(L).aspect())
                         : shadow::whole_content(*scene);
  content.casters = std::move(casters);
  return {std::move(content), in_view};
}

void set_number(lua_State* L, const char* name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

// A table { view = , projection = }.
void push_view(lua_State* L, const shadow::LightView& view) {
  lua_newtable(L);
  push(L, view.view);
  lua_setfield(L, -2, "view");
  push(L, view.projection);
  lua_setfield(L, -2, "projection");
}

// ---- the functions

int light_view(lua_State* L) {
  const auto light = light_argument(L, 1, "light_view");
  const SceneBox& scene = scene_argument(L, 2, "light_view");
  const FittedTo fit = read_fit(L, 3, "light_view", scene);
  const auto view = shadow::light_view(light, *scene, fit.content);
  // A map of the whole scene may be kept for what another camera sees.
  if (const auto& planned = Stage::of(L).planned; planned && fit.in_view)
    planned->add_map({scene, light, view.view, view.projection});
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
  const FittedTo fit = read_fit(L, 3, "cube_range", scene);
  if (const auto& planned = Stage::of(L).planned) planned->add_cube(scene, light, fit.in_view);
  const auto range = shadow::cube_range(light, *scene, fit.content);
  lua_pushnumber(L, range.near);
  lua_pushnumber(L, range.far);
  return 2;
}

int faces_needed(lua_State* L) {
  const auto light = light_argument(L, 1, "faces_needed");
  const SceneBox& scene = scene_argument(L, 2, "faces_needed");
  const auto needed =
      shadow::faces_needed(light, *scene, read_fit(L, 3, "faces_needed", scene).content);
  lua_newtable(L);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    lua_pushboolean(L, needed[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int split_distances(lua_State* L) {
  const auto distances =
      shadow::split_distances(read<double>(L, 1, "argument 1 of shadow.split_distances (near)"),
                              read<double>(L, 2, "argument 2 of shadow.split_distances (far)"),
                              integer_argument(L, 3, "split_distances", 1, 64),
                              read<double>(L, 4, "argument 4 of shadow.split_distances (lambda)"));
  lua_newtable(L);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    lua_pushnumber(L, distances[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int depth_present(lua_State* L) {
  const auto& box = read_box<CameraBox>(L, 1, "argument 1 of shadow.depth_present (the camera)");
  const auto range = shadow::depth_present(*box.scene, box.camera(), Stage::of(L).aspect());
  lua_pushnumber(L, range.near);
  lua_pushnumber(L, range.far);
  return 2;
}

// Whether anybody reads the map: all are read, unless the frame is planned.
bool is_read(lua_State* L, const SceneBox& scene, glm::dvec4 light, const shadow::LightView& view,
             std::optional<shadow::DepthRange> part, std::optional<int> size) {
  Stage& stage = Stage::of(L);
  if (!stage.planned) return true;
  Planned::Map& map = stage.planned->add_map({scene, light, view.view, view.projection, part});
  if (!size) return true;
  constexpr double hardware_filter = 2;  // texels: the widest single lookup
  map.skipped = !stage.planned->needs_of(map, *size, hardware_filter, stage.picture_size()).read();
  return !map.skipped;
}

int cascades(lua_State* L) {
  using Fit = shadow::CascadeOptions::Fit;
  const auto& box = read_box<CameraBox>(L, 1, "argument 1 of shadow.cascades (the camera)");
  const auto light = light_argument(L, 2, "cascades");
  const int count = integer_argument(L, 3, "cascades", 1, 64);
  shadow::CascadeOptions options;
  shadow::DepthRange range{box.camera().near, box.camera().far};
  bool stable = false, around_camera = false, sized = false;
  static constexpr std::string_view names[] = {"lambda", "stable", "around", "size", "near", "far"};
  each_option(L, 4, "cascades", names, [&](std::string_view key) {
    if (key == "lambda") options.lambda = number_option(L, key);
    if (key == "stable") stable = lua_toboolean(L, -1);
    if (key == "around") around_camera = is_first_of(L, key, "camera", "parts");
    sized = sized || key == "size";
    if (key == "size") options.size = integer_argument(L, lua_gettop(L), "cascades", 1, 16384);
    if (key == "near") range.near = number_option(L, key);
    if (key == "far") range.far = number_option(L, key);
  });
  options.fit = around_camera ? Fit::camera : stable ? Fit::stable : Fit::tight;
  const auto cascades = shadow::cascades(*box.scene, box.camera(), Stage::of(L).aspect(), light,
                                         count, range, options);
  lua_newtable(L);
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    const auto& [near, far, view] = cascades[i];
    push_view(L, view);
    set_number(L, "near", near);
    set_number(L, "far", far);
    // Those around the camera are read where they reach, the others where a part does: the first
    // from the eye on.
    std::optional<shadow::DepthRange> part;
    if (!around_camera) part = {i == 0 ? std::min(near, box.camera().near) : near, far};
    const bool read = is_read(L, box.scene, light, view, part,
                              sized ? std::optional(options.size) : std::nullopt);
    lua_pushboolean(L, read);
    lua_setfield(L, -2, "read");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

constexpr Entry functions[] = {
    {"light_view",
     "shadow.light_view(light, scene, {fit = \"view\"|\"scene\", casters = {object, …}}) -> view, "
     "projection, near, far",
     "The light's view and projection for a shadow map, fitted to the casters that can shadow what "
     "the camera sees (or, fit = \"scene\", anything), and to those shadows alone: what is outside "
     "of the map or behind the light is lit. Orthographic for a light at infinity. Refused where a "
     "point light is among its casters, so that one frustum cannot hold them.",
     guarded<light_view>},
    {"map_bias",
     "shadow.map_bias(projection, size, filter) -> {factor, units, normal_offset, texel, read}",
     "The least bias without acne for a map of size × size texels drawn with this projection and "
     "read by a filter so many texels wide (1 unless given): factor and units for "
     "gl.PolygonOffset, or normal_offset · sin θ along the receiver's normal, θ being the angle "
     "from normal to light, and texel the side of a texel; both in metres, under a perspective for "
     "each metre along its axis. read: whether anybody reads such a map, which under run --plan is "
     "so only where a caster may shadow what is seen; it need not be made otherwise.",
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
    {"split_distances", "shadow.split_distances(near, far, n, lambda) -> {near, …, far}",
     "The n + 1 distances at which a view is split: lambda · near · (far/near)^(i/n) + (1 - "
     "lambda) · (near + (far - near) · i/n).",
     guarded<split_distances>},
    {"depth_present", "shadow.depth_present(camera) -> near, far",
     "The least and the greatest distance along the view at which the camera sees anything.",
     guarded<depth_present>},
    {"cascades",
     "shadow.cascades(camera, light, n, {lambda = 0.5, stable = false, around = "
     "\"parts\"|\"camera\", size = 1024, near = , far = }) -> { {near = , far = , view = , "
     "projection = , read = boolean}, … }",
     "n maps for the camera's view: where each part of it begins and ends, the light's view of it, "
     "and whether anybody reads it: all are read, but under run --plan those alone that can show a "
     "shadow, if size is given, to lookups of up to 2 texels. Stable ones do not swim as the "
     "camera moves; around = \"camera\" are concentric ones. "
     "Both move in whole texels of a map of size × size and take a light at infinity.",
     guarded<cascades>},
};

}  // namespace

std::span<const Entry> map_functions() { return functions; }

}  // namespace shadowlab::lua
