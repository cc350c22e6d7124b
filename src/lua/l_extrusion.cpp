// shadow.extrusion: shadow volumes that shaders make.
#include <fmt/format.h>

#include <algorithm>

#include "lua/boxes.h"
#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

// A doubled mesh takes about 1.2 KB a triangle.
constexpr std::size_t most_doubled = 200'000;
// Runs of one mesh that are kept: a light that moves may cut it in others.
constexpr std::size_t most_runs = 64;

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
                                                   const shadow::FacingPlanes& planes,
                                                   shadow::TriangleRange run) {
  static constexpr GLint components[] = {3};
  const auto positions = planes.positions();
  const std::span floats(reinterpret_cast<const float*>(positions.data()), positions.size() * 3);
  return std::make_unique<gl::FixedElements>(graphics.gl, graphics.calls(), floats, components,
                                             shadow::run_with_adjacency(planes, run));
}

Extrusion::Stage stage_argument(lua_State* L, int index) {
  const std::string_view text = lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : "";
  if (text == "vertex") return Extrusion::Stage::vertex;
  if (text == "geometry") return Extrusion::Stage::geometry;
  throw InputError(
      "shadow.extrusion: argument 2 is \"vertex\" or \"geometry\", the shader that extrudes; it "
      "is " +
      describe(L, index));
}

// The part that { part = , light = } names of those of shadow.parts; all triangles without it.
shadow::TriangleRange run_argument(lua_State* L, int index, VolumeSource& source,
                                   const glm::dmat4& model) {
  const std::size_t all = source.builder.triangle_count();
  if (lua_isnoneornil(L, index)) return {0, all};
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError(
        "shadow.extrusion's options are a table, as { part = 1, light = light }; it is " +
        describe(L, index));
  }
  lua_getfield(L, index, "part");
  const double part = read<double>(L, -1, "part");
  lua_getfield(L, index, "light");
  const auto light = read_light(L, lua_gettop(L), "light");
  lua_pop(L, 2);
  const shadow::TriangleRange run =
      part_of(source, light_as_drawn(source, model, light), part, "extrusion");
  return {run.first, std::min(run.last, all)};
}

std::shared_ptr<VolumeSource::Extrudable> elements_of(Stage& stage, VolumeSource& source,
                                                      shadow::TriangleRange run,
                                                      Extrusion::Stage extruder) {
  using shadow::DoubledMesh;
  if (source.extrudables.size() > most_runs) source.extrudables.clear();
  auto& elements = source.extrudables[{run.first, run.last}];
  if (!elements) elements = std::make_shared<VolumeSource::Extrudable>(stage.state);
  const bool vertex = extruder == Extrusion::Stage::vertex;
  if (vertex ? elements->doubled != nullptr : elements->adjacent != nullptr) return elements;
  stage.state.check_budget(run.count() * 24);
  const shadow::FacingPlanes& planes = source.builder.facing();
  if (vertex) {
    // And the faces alone, with three vertices and indices each.
    elements->reserve(run.count() *
                      ((DoubledMesh::vertices_a_triangle + 3) * sizeof(shadow::ExtrudedVertex) +
                       (DoubledMesh::indices_a_triangle + 3) * sizeof(std::uint32_t)));
    elements->doubled = upload(stage.graphics, shadow::doubled_mesh(planes, run));
    elements->separate = upload(stage.graphics, shadow::separate_faces(planes, run));
  } else {
    elements->reserve(planes.positions().size_bytes() + run.count() * 6 * sizeof(std::uint32_t));
    elements->adjacent = upload_adjacent(stage.graphics, planes, run);
  }
  return elements;
}

std::string what_is_drawn(lua_State* L, const Extrusion& extrusion) {
  const auto* object = test_box<ObjectBox>(L, 1);
  return fmt::format("The volume of {} is made by the {} shader from {} triangles.",
                     object ? object->object().name : "the caster",
                     extrusion.stage == Extrusion::Stage::vertex ? "vertex" : "geometry",
                     extrusion.triangles.count());
}

int make(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "extrusion");
  Extrusion extrusion;
  extrusion.stage = stage_argument(L, 2);
  extrusion.model = caster_model(L, 3, "extrusion");
  Stage& stage = Stage::of(L);
  extrusion.source = stage.volumes->source(mesh);
  extrusion.triangles = run_argument(L, 4, *extrusion.source, extrusion.model);
  if (extrusion.stage == Extrusion::Stage::vertex && extrusion.triangles.count() > most_doubled) {
    throw InputError(
        fmt::format("shadow.extrusion: the mesh has {} triangles; \"vertex\" takes {} at most, "
                    "\"geometry\" any",
                    extrusion.triangles.count(), most_doubled));
  }
  extrusion.elements = elements_of(stage, *extrusion.source, extrusion.triangles, extrusion.stage);
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
  const scene::Light light = read_light(L, lua_gettop(L), "light");
  lua_pop(L, 3);
  // The very floats that the shader extrudes from, so that its sides and its facings agree.
  seen.light = light_as_drawn(*extrusion.source, seen.model, light);
  seen.eye = shadow::light_in_model_space(seen.model, glm::inverse(view)[3]);
  return seen;
}

Derived vector(const char* name, const glm::dvec4& v) { return {name, {v.x, v.y, v.z, v.w}}; }

int draw(lua_State* L) {
  const Extrusion& extrusion = read_box<Extrusion>(L, 1, "extrusion:draw: self");
  const Seen seen = read_seen(L, extrusion, 3);
  const VolumeSource& source = *extrusion.source;
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  const gl::FixedElements& elements =
      vertex ? *extrusion.elements->doubled : *extrusion.elements->adjacent;
  const std::size_t each = vertex ? shadow::DoubledMesh::indices_a_triangle : 6;
  const auto scaled = source.builder.facing().scaled(seen.light);
  const double mirrored = glm::determinant(glm::dmat3(seen.model)) < 0 ? 1 : 0;
  for (const auto& run : shadow::ruled_runs(source.builder, seen.light, extrusion.triangles)) {
    const Derived derived[] = {vector("volume_light", seen.light),
                               vector("facing_light", scaled.light),
                               {"facing_bound", {scaled.bound}},
                               {"lit_faces_alone", {run.lit_faces_alone ? 1.0 : 0.0}},
                               {"mirrored", {mirrored}}};
    const std::size_t first = (run.triangles.first - extrusion.triangles.first) * each,
                      count = run.triangles.count() * each;
    draw_with({L, 2, 3}, extrusion.model, {}, count, derived, "shadow volume by its shader",
              [&] { elements.draw(vertex ? GL_TRIANGLES : GL_TRIANGLES_ADJACENCY, first, count); });
  }
  return 0;
}

int draw_unlit(lua_State* L) {
  const Extrusion& extrusion = read_box<Extrusion>(L, 1, "extrusion:draw_unlit: self");
  const Seen seen = read_seen(L, extrusion, 3);
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  const gl::FixedElements& elements =
      vertex ? *extrusion.elements->separate : *extrusion.elements->adjacent;
  const shadow::FacingPlanes& planes = extrusion.source->builder.facing();
  const auto light = planes.scaled(seen.light), eye = planes.scaled(seen.eye);
  const Derived derived[] = {vector("volume_light", seen.light),
                             vector("volume_eye", seen.eye),
                             vector("facing_light", light.light),
                             vector("facing_eye", eye.light),
                             {"facing_bound", {std::max(light.bound, eye.bound)}}};
  const std::size_t count = extrusion.triangles.count() * (vertex ? 3 : 6);
  draw_with({L, 2, 3}, extrusion.model, {}, count, derived, "sides turned from the light",
            [&] { elements.draw(vertex ? GL_TRIANGLES : GL_TRIANGLES_ADJACENCY, 0, count); });
  return 0;
}

constexpr Entry functions[] = {
    {"extrusion", "shadow.extrusion(mesh, \"vertex\"|\"geometry\", model) -> extrusion",
     "A mesh, or a scene's object (model may then be nil), as the shaders \"extrude_vertex\" or "
     "\"extrude_geometry\" take it, which make its shadow volume by themselves: nothing is "
     "computed "
     "or sent when the light moves. Of a caster that shadow.parts draws in parts for a light, one "
     "of "
     "them.",
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
  const bool vertex = extrusion.stage == Extrusion::Stage::vertex;
  const std::size_t each = vertex ? shadow::DoubledMesh::indices_a_triangle / 3 : 1;
  lua_pushinteger(L, static_cast<lua_Integer>(extrusion.triangles.count() * each));
  return true;
}

std::span<const std::string_view> BoxTraits<Extrusion>::fields() { return field_names; }

std::span<const Entry> extrusion_functions() { return functions; }
std::span<const Entry> extrusion_methods() { return methods; }

void open_extrusion(Stage& stage) { open_box<Extrusion>(stage.state.raw(), methods); }

}  // namespace shadowlab::lua
