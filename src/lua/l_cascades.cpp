// shadow.*: several maps for one view.
#include "lua/map_arguments.h"
#include "lua/modules.h"
#include "lua/planned.h"
#include "shadow/cascades.h"

namespace shadowlab::lua {
namespace {

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

std::span<const Entry> cascade_functions() { return functions; }

}  // namespace shadowlab::lua
