// What is asked of a caster and a light: its silhouette and edge graph, z-pass or z-fail, in how
// many parts its volume is drawn.
#include <fmt/format.h>

#include <cmath>

#include "lua/boxes.h"
#include "lua/planned.h"
#include "lua/volume_pool.h"
#include "shadow/back.h"
#include "shadow/silhouette.h"
#include "shadow/volume.h"
#include "shadow/zfail.h"

namespace shadowlab::lua {

MeshBox caster_mesh(lua_State* L, int index, const char* function) {
  if (const auto* object = test_box<ObjectBox>(L, index)) return object->object().mesh;
  if (const auto* mesh = test_box<MeshBox>(L, index)) return *mesh;
  return read_box<MeshBox>(L, index, fmt::format("argument {} of shadow.{}", index, function));
}

glm::dmat4 caster_model(lua_State* L, int index, const char* function) {
  if (lua_isnoneornil(L, index)) {
    const auto* object = test_box<ObjectBox>(L, 1);
    return object ? object->object().model : glm::dmat4(1);
  }
  if (const auto* model = test<glm::dmat4>(L, index)) return *model;
  return read<glm::dmat4>(
      L, index,
      fmt::format("argument {} of shadow.{} (the model matrix)", index, function).c_str());
}

glm::dvec4 light_as_drawn(const VolumeSource& source, const glm::dmat4& model,
                          const scene::Light& light) {
  const glm::dvec4 there(glm::vec4(shadow::light_in_model_space(model, light.position)));
  return glm::dvec4(glm::vec4(source.builder.facing().beside(there)));
}

std::string caster_name(lua_State* L, int index) {
  const auto* object = test_box<ObjectBox>(L, index);
  return object ? object->object().name : "the caster";
}

shadow::TriangleRange part_of(VolumeSource& source, glm::dvec4 light, double part,
                              const char* function) {
  const auto parts = source.layers.parts(light);
  if (!(part >= 1 && part <= static_cast<double>(parts.size())) || part != std::floor(part)) {
    throw InputError(
        fmt::format("shadow.{}: there is no part {}; for this light there {}", function, part,
                    parts.size() == 1 ? "is one" : fmt::format("are {}", parts.size())));
  }
  return parts[static_cast<std::size_t>(part) - 1].triangles;
}

namespace {

std::string why_zfail(const std::string& caster, const std::optional<shadow::Parting>& apart) {
  if (!apart) {
    return fmt::format(
        "{} needs z-fail: its box meets the pyramid from the near rectangle to the light, so part "
        "of the near plane may be in its shadow, where z-pass would count from a wrong start.",
        caster);
  }
  const glm::dvec3& n = apart->direction;
  return fmt::format(
      "z-pass is right for {}: a plane with normal ({:.2f}, {:.2f}, {:.2f}) parts its box from the "
      "pyramid from the near rectangle to the light, {:.2f} m apart.",
      caster, n.x, n.y, n.z, apart->gap);
}

int needs_zfail(lua_State* L) {
  const auto& camera = read_box<CameraBox>(L, 1, "argument 1 of shadow.needs_zfail").camera();
  const auto light = read_light(L, 2, "argument 2 of shadow.needs_zfail");
  const MeshBox mesh = caster_mesh(L, 3, "needs_zfail");
  const auto* object = test_box<ObjectBox>(L, 3);
  const glm::dmat4 model =
      !lua_isnoneornil(L, 4)
          ? read<glm::dmat4>(L, 4, "argument 4 of shadow.needs_zfail (the model matrix)")
      : object ? object->object().model
               : glm::dmat4(1);
  Stage& stage = Stage::of(L);
  const auto apart = shadow::apart_from_near_pyramid(camera, stage.aspect(), light.position,
                                                     scene::bounds(*mesh), model);
  if (stage.explaining) stage.explain(why_zfail(caster_name(L, 3), apart));
  lua_pushboolean(L, !apart);
  return 1;
}

int hides_its_back(lua_State* L) {
  const ObjectBox& object = read_box<ObjectBox>(L, 1, "argument 1 of shadow.hides_its_back");
  const auto view = read<glm::dmat4>(L, 2, "argument 2 of shadow.hides_its_back (the view)");
  const auto projection =
      read<glm::dmat4>(L, 3, "argument 3 of shadow.hides_its_back (the projection)");
  const scene::Mesh& mesh = *object.object().mesh;
  lua_pushboolean(L, shadow::is_solid_box(mesh) &&
                         shadow::hides_its_back(scene::bounds(mesh),
                                                projection * view * object.object().model));
  return 1;
}

int parts(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "parts");
  const glm::dmat4 model = caster_model(L, 2, "parts");
  const auto light = read_light(L, 3, "argument 3 of shadow.parts (the light)");
  Stage& stage = Stage::of(L);
  stage.state.check_budget(mesh->indices.size());
  if (is_dropped(L, 1, 2, light)) {
    lua_createtable(L, 0, 0);
    return 1;
  }
  const auto source = stage.volumes->source(mesh);
  const auto found = source->layers.parts(light_as_drawn(*source, model, light));
  lua_createtable(L, static_cast<int>(found.size()), 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    lua_pushinteger(L, static_cast<lua_Integer>(found[i].layers));
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

/// The edge graph, for those who write their own silhouette: 1-based, as Lua counts.
int adjacency(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "adjacency");
  Stage& stage = Stage::of(L);
  stage.state.check_budget(mesh->indices.size() * 4);
  const auto source = stage.volumes->source(mesh);
  const scene::Adjacency& graph = source->adjacency;
  lua_createtable(L, 0, 3);
  lua_createtable(L, static_cast<int>(graph.positions.size()), 0);
  for (std::size_t i = 0; i < graph.positions.size(); ++i) {
    push(L, glm::dvec3(graph.positions[i]));
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, "positions");
  const auto put = [L](const auto& rows, lua_Integer offset, const char* name) {
    lua_createtable(L, static_cast<int>(rows.size()), 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      lua_createtable(L, 3, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        lua_pushinteger(L, static_cast<lua_Integer>(rows[i][k]) + offset);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k) + 1);
      }
      lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_setfield(L, -2, name);
  };
  put(graph.triangles, 1, "triangles");
  put(source->next, 1, "next");  // 0 where there is none
  return 1;
}

/// A list of { a, b }: vec3s in model space, directed so that the caster's lit side is on the left.
int silhouette(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "silhouette");
  const glm::dmat4 model = caster_model(L, 2, "silhouette");
  const auto light = read_light(L, 3, "argument 3 of shadow.silhouette (the light)");
  const auto source = Stage::of(L).volumes->source(mesh);
  const auto edges =
      shadow::silhouette(source->adjacency, shadow::light_in_model_space(model, light.position));
  lua_createtable(L, static_cast<int>(edges.size()), 0);
  lua_Integer next = 0;
  for (const auto& edge : edges) {
    for (std::uint32_t copy = 0; copy < edge.multiplicity; ++copy) {
      lua_createtable(L, 2, 0);
      push(L, glm::dvec3(source->adjacency.positions[edge.a]));
      lua_rawseti(L, -2, 1);
      push(L, glm::dvec3(source->adjacency.positions[edge.b]));
      lua_rawseti(L, -2, 2);
      lua_rawseti(L, -2, ++next);
    }
  }
  return 1;
}

constexpr Entry functions[] = {
    {"needs_zfail",
     "shadow.needs_zfail(camera, light, object) or (camera, light, mesh, model) -> boolean",
     "Whether z-pass would be wrong for this caster: it may shadow part of the near plane.",
     guarded<needs_zfail>},
    {"hides_its_back", "shadow.hides_its_back(object, view, projection) -> boolean",
     "Whether the object's front hides, at every pixel, its sides that are turned from the camera: "
     "it is a box, closed, and the near plane does not cut it. Those sides may then be culled.",
     guarded<hides_its_back>},
    {"parts", "shadow.parts(mesh, model, light) -> { layers, … }",
     "The parts in which to draw the caster's volume, for each an upper bound, at most 127, of how "
     "often it holds one point: as far as 7 bits of the stencil count. One for most casters; "
     "shadow.volume's option part takes its number.",
     guarded<parts>},
    {"adjacency", "shadow.adjacency(mesh) -> { positions, triangles, next }",
     "The edge graph with vertices welded by position: next[i][k] is the triangle across the k-th "
     "edge of triangle i, 0 for none; counted from 1.",
     guarded<adjacency>},
    {"silhouette", "shadow.silhouette(mesh, model, light) -> { {a, b}, … }",
     "The silhouette's edges as seen from the light, model space.", guarded<silhouette>},
};

}  // namespace

std::span<const Entry> silhouette_functions() { return functions; }

}  // namespace shadowlab::lua
