// shadow.plan: what a frame needs, and why.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/modules.h"
#include "lua/plan_words.h"
#include "lua/planned.h"
#include "shadow/map_needs.h"
#include "shadow/plan.h"

namespace shadowlab::lua {
namespace {

void push_rectangle(lua_State* L, const shadow::PixelRectangle& rectangle) {
  const int values[] = {rectangle.x, rectangle.y, rectangle.width, rectangle.height};
  lua_createtable(L, 4, 0);
  for (int i = 0; i < 4; ++i) {
    lua_pushinteger(L, values[i]);
    lua_rawseti(L, -2, i + 1);
  }
}

// A scene's objects, each the same value wherever a plan names it; made when first asked for.
class Objects {
 public:
  Objects(lua_State* L, const SceneBox& scene) : L_(L), scene_(scene) {
    lua_createtable(L, static_cast<int>(scene->objects.size()), 0);
    made_ = lua_gettop(L);
  }
  void push(std::size_t index) const {
    const auto key = static_cast<lua_Integer>(index) + 1;
    if (lua_rawgeti(L_, made_, key) != LUA_TNIL) return;
    lua_pop(L_, 1);
    push_box<ObjectBox>(L_, {scene_, index});
    lua_pushvalue(L_, -1);
    lua_rawseti(L_, made_, key);
  }
  // Sets field `name` of the table on top to a list of objects.
  template <class Range, class IndexOf>
  void set(const char* name, const Range& range, IndexOf index_of) const {
    lua_createtable(L_, static_cast<int>(range.size()), 0);
    lua_Integer next = 0;
    for (const auto& item : range) {
      push(index_of(item));
      lua_rawseti(L_, -2, ++next);
    }
    lua_setfield(L_, -2, name);
  }

 private:
  lua_State* L_;
  const SceneBox& scene_;
  int made_;
};

void push_need(lua_State* L, const shadow::Plan::Kept& kept) {
  lua_createtable(L, 0, 3);
  lua_pushboolean(L, !kept.apart);
  lua_setfield(L, -2, "zfail");
  lua_pushboolean(L, kept.unlit);
  lua_setfield(L, -2, "unlit");
  if (kept.scissor.area() == 0) return;
  push_rectangle(L, kept.scissor);
  lua_setfield(L, -2, "scissor");
}

// The maps of { maps = { {view = , projection = , near = , far = }, … }, size = , filter = } at
// `index`; near and far, as shadow.cascades gives them, are where along the view it is read.
std::vector<shadow::MapUse> read_maps(lua_State* L, int index) {
  std::vector<shadow::MapUse> maps;
  if (lua_isnoneornil(L, index)) return maps;
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError(
        "argument 4 of shadow.plan is a table, { maps = , size = , filter = }; it is " +
        describe(L, index));
  }
  lua_getfield(L, index, "size");
  lua_getfield(L, index, "filter");
  const double size = read<double>(L, -2, "size of argument 4 of shadow.plan");
  const double filter =
      lua_isnil(L, -1) ? 1 : read<double>(L, -1, "filter of argument 4 of shadow.plan");
  if (!(size >= 1 && size <= 16384 && filter >= 1 && filter <= 16384))
    throw InputError("shadow.plan: size and filter of maps are from 1 to 16384 texels");
  if (lua_getfield(L, index, "maps") != LUA_TTABLE)
    throw InputError("shadow.plan: maps is a table of maps; it is " + describe(L, -1));
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TTABLE && maps.size() < 64; ++i) {
    lua_getfield(L, -1, "projection");
    lua_getfield(L, -2, "view");
    shadow::MapUse map{read<glm::dmat4>(L, -2, "projection of a map of shadow.plan") *
                           read<glm::dmat4>(L, -1, "view of a map of shadow.plan"),
                       static_cast<int>(size),
                       filter,
                       {}};
    lua_getfield(L, -3, "near");
    lua_getfield(L, -4, "far");
    if (!lua_isnil(L, -2)) {
      map.part = {read<double>(L, -2, "near of a map of shadow.plan"),
                  read<double>(L, -1, "far of a map of shadow.plan")};
      if (!(map.part->near > 0 && map.part->far > map.part->near))
        throw InputError("shadow.plan: of a map, 0 < near < far");
    }
    maps.push_back(map);
    lua_pop(L, 5);
  }
  lua_pop(L, 4);
  return maps;
}

int plan(lua_State* L) {
  const SceneBox scene = read_box<SceneBox>(L, 1, "argument 1 of shadow.plan (the scene)");
  const auto& seen_by = read_box<CameraBox>(L, 2, "argument 2 of shadow.plan");
  const scene::Camera& camera = seen_by.camera();
  const auto light = read_light(L, 3, "argument 3 of shadow.plan (the light)");
  if (light.shape != scene::Light::Shape::point) {
    throw InputError(
        "shadow.plan takes a point or a direction; plan for each sample of a light with a size");
  }
  Stage& stage = Stage::of(L);
  stage.state.check_budget(scene->objects.size() * scene->objects.size());
  const glm::ivec2 picture = stage.picture_size();
  const shadow::Plan plan =
      stage.planned && seen_by.scene == scene
          ? stage.planned->plan_of(scene, light.position, picture, reasons_for(stage))
          : shadow::plan(*scene, camera, light.position, picture, reasons_for(stage));
  if (stage.explaining) explain_plan(stage, *scene, light.position, plan);
  const std::vector<shadow::MapUse> maps = read_maps(L, 4);

  const auto itself = [](std::size_t index) { return index; };
  const Objects objects(L, scene);
  lua_createtable(L, 0, 7);
  objects.set("seen", plan.seen, itself);
  objects.set("shadowed", plan.shadowed, itself);
  objects.set("dropped", plan.dropped, [](const auto& d) { return d.object; });
  objects.set("casters", plan.casters, [](const auto& kept) { return kept.object; });
  push_rectangle(L, plan.shadows);
  lua_setfield(L, -2, "scissor");
  lua_createtable(L, static_cast<int>(maps.size()), 0);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const auto needs =
        shadow::map_needs(*scene, camera, light.position, stage.picture_size(), maps[i]);
    lua_createtable(L, 0, 2);
    objects.set("casters", needs.casters, itself);
    lua_pushboolean(L, needs.read());
    lua_setfield(L, -2, "read");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "maps");
  lua_createtable(L, 0, static_cast<int>(plan.casters.size()));
  for (const shadow::Plan::Kept& kept : plan.casters) {
    objects.push(kept.object);
    push_need(L, kept);
    lua_rawset(L, -3);
  }
  lua_setfield(L, -2, "needs");
  return 1;
}

constexpr Entry functions[] = {
    {"plan",
     "shadow.plan(scene, camera, light, {maps = {{view = , projection = , near = , far = }, …}, "
     "size "
     "= , filter = 1}) -> {casters = {object, …}, needs = {[caster] = {zfail = "
     "boolean, unlit = boolean, scissor = {x, y, width, height} or nil}}, scissor = , seen = "
     "{object, …}, shadowed = "
     "{object, …}, dropped = {object, …}, maps = {{casters = {object, …}, read = boolean}, …}}",
     "What a frame of shadow volumes needs, for the same picture pixel for pixel: casters whose "
     "volume can reach what the camera sees, and of each whether it needs z-fail and its caps, "
     "outside of which pixels it counts zero (nil: everywhere, and no volume is needed), and "
     "whether it may be seen from a side turned from the light. seen: the objects to draw; "
     "shadowed: those of them "
     "that a shadow may reach; scissor: where. And of maps of size × size texels, as "
     "shadow.cascades "
     "or shadow.cube_faces give them, the casters that a lookup filter texels wide at what is seen "
     "can meet, and whether there are any. The light is a point or a direction.",
     guarded<plan>},
};

}  // namespace

std::span<const Entry> plan_functions() { return functions; }

}  // namespace shadowlab::lua
