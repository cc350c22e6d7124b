// shadow.extrusion: shadow volumes that shaders make.
#include <fmt/format.h>

#include <cstring>

#include "lua/boxes.h"
#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

// A doubled mesh takes about 1.2 KB a triangle.
constexpr std::size_t most_doubled = 200'000;

std::span<const float> floats_of(const std::vector<shadow::ExtrudedVertex>& vertices) {
  static_assert(sizeof(shadow::ExtrudedVertex) == 15 * sizeof(float));
  return {reinterpret_cast<const float*>(vertices.data()), vertices.size() * 15};
}

std::unique_ptr<gl::FixedElements> upload(gl::Graphics& graphics, const shadow::DoubledMesh& mesh) {
  static constexpr GLint components[] = {4, 3, 4, 4};
  return std::make_unique<gl::FixedElements>(graphics.gl, graphics.calls(),
                                             floats_of(mesh.vertices), components, mesh.indices);
}

std::unique_ptr<gl::FixedElements> upload_adjacent(gl::Graphics& graphics,
                                                   const VolumeSource& source) {
  static constexpr GLint components[] = {3};
  const auto& positions = source.adjacency.positions;
  const std::span floats(reinterpret_cast<const float*>(positions.data()), positions.size() * 3);
  return std::make_unique<gl::FixedElements>(
      graphics.gl, graphics.calls(), floats, components,
      shadow::ordered_with_adjacency(source.adjacency, source.extrudable->order));
}

std::string what_is_drawn(lua_State* L, const Extrusion& extrusion) {
  const auto* object = test_box<ObjectBox>(L, 1);
  const std::string caster = object ? object->object().name : "the caster";
  const std::size_t triangles = extrusion.source->adjacency.triangles.size(),
                    closed = extrusion.source->extrudable->order.closed;
  return fmt::format(
      "The volume of {} is made by the {} shader from {} triangles; {} of them are of closed parts "
      "and count only where they face the light.",
      caster, extrusion.stage == Extrusion::Stage::vertex ? "vertex" : "geometry", triangles,
      closed == triangles ? "all"
      : closed == 0       ? "none"
                          : std::to_string(closed));
}

int make(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "extrusion");
  const char* const text = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  const bool vertex = std::strcmp(text, "vertex") == 0;
  if (!vertex && std::strcmp(text, "geometry") != 0) {
    throw InputError(
        "shadow.extrusion: argument 2 is \"vertex\" or \"geometry\", the shader that "
        "extrudes; it is " +
        describe(L, 2));
  }
  Stage& stage = Stage::of(L);
  Extrusion extrusion{stage.volumes->source(mesh),
                      vertex ? Extrusion::Stage::vertex : Extrusion::Stage::geometry,
                      caster_model(L, 3, "extrusion")};
  VolumeSource& source = *extrusion.source;
  if (vertex && source.adjacency.triangles.size() > most_doubled) {
    throw InputError(
        fmt::format("shadow.extrusion: the mesh has {} triangles; \"vertex\" takes {} at most, "
                    "\"geometry\" any",
                    source.adjacency.triangles.size(), most_doubled));
  }
  if (!source.extrudable) {
    stage.state.check_budget(mesh->indices.size() * 24);
    source.extrudable = std::make_unique<VolumeSource::Extrudable>();
    source.extrudable->order = shadow::extrusion_order(source.adjacency);
  }
  VolumeSource::Extrudable& parts = *source.extrudable;
  if (vertex && !parts.doubled) {
    parts.doubled =
        upload(stage.graphics, shadow::doubled_mesh(source.adjacency, source.facing, parts.order));
  }
  if (!vertex && !parts.adjacent) parts.adjacent = upload_adjacent(stage.graphics, source);
  if (stage.explaining) stage.explain(what_is_drawn(L, extrusion));
  push_box<Extrusion>(L, std::move(extrusion));
  return 1;
}

// What a draw's table says that decides facing. The model is the object's own unless it says other.
struct Seen {
  glm::dvec4 light{0}, eye{0};  // model space, normalized
  glm::dmat4 model{1};
};

Seen read_seen(lua_State* L, const Extrusion& extrusion, int table) {
  if (lua_type(L, table) != LUA_TTABLE) {
    throw InputError(
        "an extrusion's draw takes a table, as { view = , projection = , light = }; "
        "it is " +
        describe(L, table));
  }
  Seen seen;
  seen.model = extrusion.model;
  if (lua_getfield(L, table, "model") != LUA_TNIL) seen.model = read<glm::dmat4>(L, -1, "model");
  glm::dmat4 view(1);
  if (lua_getfield(L, table, "view") != LUA_TNIL) view = read<glm::dmat4>(L, -1, "view");
  if (lua_getfield(L, table, "light") == LUA_TNIL)
    throw InputError("an extrusion is drawn with a light; give light in the draw's table");
  const glm::dvec4 light = read_light(L, lua_gettop(L), "light").position;
  lua_pop(L, 3);
  // The very floats that the shader extrudes from, so that its sides and its facings agree.
  seen.light = glm::dvec4(glm::vec4(shadow::light_in_model_space(seen.model, light)));
  seen.eye = shadow::light_in_model_space(seen.model, glm::inverse(view)[3]);
  return seen;
}

Derived vector(const char* name, const glm::dvec4& v) { return {name, {v.x, v.y, v.z, v.w}}; }

int draw(lua_State* L) {
  const Extrusion& extrusion = read_box<Extrusion>(L, 1, "extrusion:draw: self");
  const Seen seen = read_seen(L, extrusion, 3);
  const VolumeSource& source = *extrusion.source;
  const VolumeSource::Extrudable& parts = *source.extrudable;
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  const gl::FixedElements& elements = vertex ? *parts.doubled : *parts.adjacent;
  const std::size_t each = vertex ? shadow::DoubledMesh::indices_a_triangle : 6;
  const std::size_t closed = parts.order.closed * each, all = parts.order.triangles.size() * each;
  const auto scaled = source.facing.scaled(seen.light);
  const auto draw_range = [&](std::size_t first, std::size_t count, bool lit_faces_alone) {
    const Derived derived[] = {
        vector("volume_light", seen.light),
        vector("facing_light", scaled.light),
        {"facing_bound", {scaled.bound}},
        {"lit_faces_alone", {lit_faces_alone ? 1.0 : 0.0}},
        {"mirrored", {glm::determinant(glm::dmat3(seen.model)) < 0 ? 1.0 : 0.0}}};
    draw_with({L, 2, 3}, extrusion.model, {}, count, derived, "shadow volume by its shader",
              [&] { elements.draw(vertex ? GL_TRIANGLES : GL_TRIANGLES_ADJACENCY, first, count); });
  };
  if (parts.order.lit_faces_suffice(seen.light)) {
    if (closed > 0) draw_range(0, closed, true);
    if (all > closed) draw_range(closed, all - closed, false);
  } else {
    draw_range(0, all, false);
  }
  return 0;
}

int draw_unlit(lua_State* L) {
  const Extrusion& extrusion = read_box<Extrusion>(L, 1, "extrusion:draw_unlit: self");
  const Seen seen = read_seen(L, extrusion, 3);
  const VolumeSource& source = *extrusion.source;
  VolumeSource::Extrudable& parts = *source.extrudable;
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  if (vertex && !parts.separate) {
    parts.separate =
        upload(Stage::of(L).graphics, shadow::separate_faces(source.adjacency, source.facing));
  }
  const auto light = source.facing.scaled(seen.light), eye = source.facing.scaled(seen.eye);
  const Derived derived[] = {vector("volume_light", seen.light),
                             vector("volume_eye", seen.eye),
                             vector("facing_light", light.light),
                             vector("facing_eye", eye.light),
                             {"facing_bound", {std::max(light.bound, eye.bound)}}};
  const std::size_t count = source.adjacency.triangles.size() * (vertex ? 3 : 6);
  draw_with({L, 2, 3}, extrusion.model, {}, count, derived, "sides turned from the light", [&] {
    const gl::FixedElements& elements = vertex ? *parts.separate : *parts.adjacent;
    elements.draw(vertex ? GL_TRIANGLES : GL_TRIANGLES_ADJACENCY, 0, count);
  });
  return 0;
}

constexpr Entry functions[] = {
    {"extrusion", "shadow.extrusion(mesh, \"vertex\"|\"geometry\", model) -> extrusion",
     "A mesh, or a scene's object (model may then be nil), as the shaders \"extrude_vertex\" or "
     "\"extrude_geometry\" take it, which make its shadow volume by themselves: nothing is "
     "computed "
     "or sent when the light moves.",
     guarded<make>},
};
constexpr Entry methods[] = {
    {"draw", "e:draw(shader, {view = , projection = , light = })",
     "Draws the volume, sides and caps: what z-fail counts. The shader is \"extrude_vertex\" or "
     "\"extrude_geometry\", as the extrusion was asked for.",
     guarded<draw>},
    {"draw_unlit", "e:draw_unlit(shader, {view = , projection = , light = })",
     "Draws the mesh's triangles of which the camera sees the side that is turned from the light, "
     "by the shader \"unlit_vertex\" or \"unlit_geometry\": those are in their own shadow.",
     guarded<draw_unlit>},
};
constexpr std::string_view field_names[] = {"primitives"};

}  // namespace

bool BoxTraits<Extrusion>::push_field(lua_State* L, Extrusion& extrusion, std::string_view key) {
  if (key != "primitives") return false;
  const std::size_t triangles = extrusion.source->adjacency.triangles.size();
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  const std::size_t each = vertex ? shadow::DoubledMesh::indices_a_triangle / 3 : 1;
  lua_pushinteger(L, static_cast<lua_Integer>(triangles * each));
  return true;
}

std::span<const std::string_view> BoxTraits<Extrusion>::fields() { return field_names; }

std::span<const Entry> extrusion_functions() { return functions; }
std::span<const Entry> extrusion_methods() { return methods; }

void open_extrusion(Stage& stage) { open_box<Extrusion>(stage.state.raw(), methods); }

}  // namespace shadowlab::lua
