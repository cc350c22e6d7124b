#include "lua/planned.h"

#include <algorithm>

#include "lua/plan_words.h"

namespace shadowlab::lua {
namespace {

const glm::dmat4* matrix(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  const glm::dmat4* found = test<glm::dmat4>(L, -1);
  lua_pop(L, 1);  // the table holds it
  return found;
}

}  // namespace

void Planned::begin_frame() {
  seen_.clear();
  volumes_.clear();
  maps_.clear();
  lookups_.clear();
  cubes_.clear();
}

const shadow::Sight& Planned::sight_of(const SceneBox& scene, glm::ivec2 picture) {
  const auto known = std::ranges::find_if(
      seen_, [&](const Seen& seen) { return seen.scene == scene && seen.picture == picture; });
  if (known != seen_.end()) return known->sight;
  seen_.push_back({scene, picture, shadow::Sight(*scene, scene->camera, picture)});
  return seen_.back().sight;
}

bool Planned::Volumes::drops(std::size_t object) const {
  return std::ranges::any_of(plan.dropped, [&](const shadow::Plan::Dropped& dropped) {
    return dropped.object == object && dropped.why != shadow::Plan::Why::all_lit;
  });
}

bool Planned::drops(const ObjectBox& caster, const scene::Light& light, glm::ivec2 picture,
                    shadow::Reasons reasons) {
  if (light.shape != scene::Light::Shape::point || !caster.object().casts()) return false;
  return volumes_of(caster.scene, light.position, picture, reasons).drops(caster.index);
}

const shadow::Plan& Planned::plan_of(const SceneBox& scene, glm::dvec4 light, glm::ivec2 picture,
                                     shadow::Reasons reasons) {
  return volumes_of(scene, light, picture, reasons).plan;
}

const Planned::Volumes& Planned::volumes_of(const SceneBox& scene, glm::dvec4 light,
                                            glm::ivec2 picture, shadow::Reasons reasons) {
  const auto same = [&](const Volumes& known) {
    return known.light == light && known.reasons == reasons && known.scene == scene;
  };
  // Asked caster by caster for one light after the other: the last is the likeliest.
  auto found = std::find_if(volumes_.rbegin(), volumes_.rend(), same);
  if (found != volumes_.rend()) return *found;
  volumes_.push_back(
      {scene, light, reasons,
       shadow::plan(*scene, scene->camera, light, sight_of(scene, picture), reasons)});
  return volumes_.back();
}

Planned::Map& Planned::add_map(Map map) {
  maps_.push_back(std::move(map));
  return maps_.back();
}

void Planned::add_cube(const SceneBox& scene, glm::dvec4 light, bool in_view) {
  cubes_.push_back({scene, light, in_view});
}

void Planned::add_cube_faces(glm::dvec4 light, std::span<const shadow::LightView> faces) {
  const auto cube = std::find_if(cubes_.rbegin(), cubes_.rend(),
                                 [&](const Cube& known) { return known.light == light; });
  if (cube == cubes_.rend() || !cube->in_view) return;
  for (const shadow::LightView& face : faces)
    add_map({cube->scene, light, face.view, face.projection});
}

bool Planned::add_lookup(const glm::dmat4& projection, int size, double filter,
                         glm::ivec2 picture) {
  lookups_.push_back({projection, size, filter});
  bool known = false, read = false;
  for (Map& map : maps_) {
    if (map.projection != projection) continue;
    known = true;
    map.skipped = !needs_of(map, size, filter, picture).read();
    read = read || !map.skipped;
  }
  return read || !known;
}

const shadow::MapNeeds& Planned::needs_of(Map& map, int size, double filter, glm::ivec2 picture) {
  if (!map.needs || map.size != size || map.filter < filter) {
    map.size = size;
    map.filter = filter;
    map.needs =
        shadow::map_needs(*map.scene, sight_of(map.scene, picture), map.light,
                          {map.projection * map.view, size, filter + map.reach * size, map.part});
  }
  return *map.needs;
}

Planned::Map* Planned::map_of(const SceneBox& scene, const glm::dmat4& view,
                              const glm::dmat4& projection, glm::ivec2 picture) {
  const auto map = std::find_if(maps_.rbegin(), maps_.rend(), [&](const Map& known) {
    return known.projection == projection && known.view == view;
  });
  if (map == maps_.rend() || map->scene->objects.size() != scene->objects.size()) return nullptr;
  int size = 0;
  double filter = 0;
  for (const Lookup& lookup : lookups_) {
    if (lookup.projection != projection) continue;
    size = size == 0 ? lookup.size : std::min(size, lookup.size);
    filter = std::max(filter, lookup.filter);
  }
  if (size > 0) needs_of(*map, size, filter, picture);
  return &*map;
}

bool is_dropped(lua_State* L, int caster, int model, const scene::Light& light) {
  Stage& stage = Stage::of(L);
  if (!stage.planned || !lua_isnoneornil(L, model)) return false;
  const ObjectBox* object = test_box<ObjectBox>(L, caster);
  return object && stage.planned->drops(*object, light, stage.picture_size(), reasons_for(stage));
}

bool is_needed(lua_State* L, int uniforms, const SceneBox& scene, std::size_t index) {
  Stage& stage = Stage::of(L);
  const scene::Object& object = scene->objects[index];
  if (!stage.planned || !object.casts() || lua_type(L, uniforms) != LUA_TTABLE) return true;
  const glm::dmat4 *view = matrix(L, uniforms, "view"),
                   *projection = matrix(L, uniforms, "projection");
  if (!view || !projection || matrix(L, uniforms, "model")) return true;
  Planned::Map* map = stage.planned->map_of(scene, *view, *projection, stage.picture_size());
  if (!map) return true;
  ++map->asked;
  if (!map->needs) return true;
  if (std::ranges::binary_search(map->needs->casters, index)) return true;
  ++map->dropped;
  map->triangles_saved += object.mesh->indices.size() / 3;
  if (stage.explaining) {
    map->pixels_saved +=
        shadow::covered_texels({*projection * *view, map->size, map->filter, map->part},
                               scene::bounds(*object.mesh), object.model);
  }
  return false;
}

}  // namespace shadowlab::lua
