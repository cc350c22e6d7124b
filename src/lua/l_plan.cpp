// shadow.plan: what a frame needs, and why.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/modules.h"
#include "lua/plan_words.h"
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

// Sets field `name` of the table on top to a list of objects.
template <class Range, class IndexOf>
void set_objects(lua_State* L, const char* name, const SceneBox& scene, const Range& range,
                 IndexOf index_of) {
  lua_createtable(L, static_cast<int>(range.size()), 0);
  lua_Integer next = 0;
  for (const auto& item : range) {
    push_box<ObjectBox>(L, {scene, index_of(item)});
    lua_rawseti(L, -2, ++next);
  }
  lua_setfield(L, -2, name);
}

// The caster's object is on top.
void push_need(lua_State* L, const shadow::Plan::Kept& kept) {
  lua_createtable(L, 0, 2);
  lua_pushboolean(L, !kept.apart);
  lua_setfield(L, -2, "zfail");
  push_rectangle(L, kept.scissor);
  lua_setfield(L, -2, "scissor");
}

int plan(lua_State* L) {
  const SceneBox scene = read_box<SceneBox>(L, 1, "argument 1 of shadow.plan (the scene)");
  const auto& camera = read_box<CameraBox>(L, 2, "argument 2 of shadow.plan").camera();
  const auto light = read_light(L, 3, "argument 3 of shadow.plan (the light)");
  if (light.shape != scene::Light::Shape::point) {
    throw InputError(
        "shadow.plan takes a point or a direction; plan for each sample of a light with a size");
  }
  Stage& stage = Stage::of(L);
  stage.state.check_budget(scene->objects.size() * scene->objects.size());
  const shadow::Plan plan = shadow::plan(*scene, camera, light.position, stage.picture_size());
  if (stage.explaining) explain_plan(stage, *scene, light.position, plan);

  const auto itself = [](std::size_t index) { return index; };
  lua_createtable(L, 0, 6);
  set_objects(L, "seen", scene, plan.seen, itself);
  set_objects(L, "shadowed", scene, plan.shadowed, itself);
  set_objects(L, "dropped", scene, plan.dropped, [](const auto& d) { return d.object; });
  set_objects(L, "casters", scene, plan.casters, [](const auto& kept) { return kept.object; });
  push_rectangle(L, plan.shadows);
  lua_setfield(L, -2, "scissor");
  // needs[caster]: by the very objects that are in casters.
  lua_createtable(L, 0, static_cast<int>(plan.casters.size()));
  lua_getfield(L, -2, "casters");
  for (std::size_t i = 0; i < plan.casters.size(); ++i) {
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i) + 1);
    push_need(L, plan.casters[i]);
    lua_rawset(L, -4);
  }
  lua_pop(L, 1);
  lua_setfield(L, -2, "needs");
  return 1;
}

constexpr Entry functions[] = {
    {"plan",
     "shadow.plan(scene, camera, light) -> {casters = {object, …}, needs = {[caster] = {zfail = "
     "boolean, scissor = {x, y, width, height}}}, scissor = , seen = {object, …}, shadowed = "
     "{object, …}, dropped = {object, …}}",
     "What a frame of shadow volumes needs, for the same picture pixel for pixel: casters whose "
     "volume can reach what the camera sees, and of each whether it needs z-fail and its caps, and "
     "outside of which pixels it counts zero. seen: the objects to draw; shadowed: those of them "
     "that a shadow may reach; scissor: where. The light is a point or a direction.",
     guarded<plan>},
};

}  // namespace

std::span<const Entry> plan_functions() { return functions; }

}  // namespace shadowlab::lua
