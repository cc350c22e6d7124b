// shadow.outlines: what of a caster is flattened onto a receiver to fill its shadow.
#include <fmt/format.h>

#include "lua/boxes.h"
#include "lua/volume_pool.h"
#include "shadow/outline.h"

namespace shadowlab::lua {
namespace {

using shadow::Filling;

// What the stencil counts to beside a bit that is not counted in.
constexpr std::size_t most_layers = 127;

std::string why(const std::string& caster, const std::string& receiver, Filling filling,
                std::size_t triangles, std::size_t all) {
  switch (filling) {
    case Filling::none:
      return fmt::format("{} cannot shadow {}: its box is not between that and the light.", caster,
                         receiver);
    case Filling::outline:
      return fmt::format("{} shadows {} by its outline, {} triangles in place of {}.", caster,
                         receiver, triangles, all);
    case Filling::around:
      return fmt::format(
          "{} shadows {} by its outline, {} triangles in place of {}, though the light is in its "
          "box: that adds the same number to all counts.",
          caster, receiver, triangles, all);
    case Filling::faces:
      return fmt::format("{} shadows {} by {} of its own {} triangles, since {} cuts its box.",
                         caster, receiver, triangles, all, receiver);
  }
  return {};
}

/// A caster, its light and its receiver, as shadow.outlines is given them.
struct Cast {
  MeshBox mesh;
  glm::dmat4 model;
  glm::dvec4 light;  ///< in the caster's space
  Filling filling;
};

// Uploads what is flattened of `triangles` and adds it to the table on top. False, with nothing
// done, where more than `most` layers are or may be too many for 7 bits.
bool append_outline(lua_State* L, const Cast& cast, shadow::TriangleRange triangles,
                    std::optional<std::size_t> layers) {
  Stage& stage = Stage::of(L);
  shadow::VolumeOptions how;
  how.triangles = triangles;
  how.handedness = glm::determinant(glm::dmat3(cast.model)) < 0 ? shadow::Handedness::mirrored
                                                                : shadow::Handedness::kept;
  const auto source = stage.volumes->source(cast.mesh);
  const shadow::Flat flat = source->builder.flat(cast.light, cast.filling, how);
  if (!layers) layers = flat.layers;
  if (!layers || *layers > most_layers) return false;
  const std::size_t beside = static_cast<std::size_t>(std::abs(flat.offset));
  if (*layers + beside > most_layers) return false;
  Outline outline{stage.volumes->next(cast.mesh), *layers + beside, flat.offset};
  Volume& volume = *outline.volume;
  volume.model = cast.model;
  volume.light = cast.light;
  volume.triangles = triangles;
  volume.buffers->upload(flat.indices);
  volume.drawn = volume.buffers.get();
  volume.sides = volume.all = flat.indices.size();
  push_box<Outline>(L, std::move(outline));
  lua_rawseti(L, -2, static_cast<lua_Integer>(lua_rawlen(L, -2)) + 1);
  return true;
}

// The triangles of the outlines in the table on top.
std::size_t triangles_in(lua_State* L) {
  std::size_t sum = 0;
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, -1)); ++i) {
    lua_rawgeti(L, -1, i);
    sum += test_box<Outline>(L, -1)->volume->all / 3;
    lua_pop(L, 1);
  }
  return sum;
}

int outlines(lua_State* L) {
  Cast cast;
  cast.mesh = caster_mesh(L, 1, "outlines");
  cast.model = caster_model(L, 2, "outlines");
  const auto light = read_light(L, 3, "argument 3 of shadow.outlines (the light)");
  const scene::Object& receiver =
      read_box<ObjectBox>(L, 4, "argument 4 of shadow.outlines (the receiver)").object();
  const auto plane = scene::plane_of(*receiver.mesh, receiver.model);
  if (!plane) {
    throw InputError(fmt::format(
        "shadow.outlines: {} is not planar, and a shadow is flattened onto planes alone",
        receiver.name));
  }
  Stage& stage = Stage::of(L);
  stage.state.check_budget(cast.mesh->indices.size());
  const auto source = stage.volumes->source(cast.mesh);
  cast.light = shadow::light_in_model_space(cast.model, light.position);
  cast.filling = shadow::filling({source->bounds, cast.model}, light.position, *plane,
                                 {scene::bounds(*receiver.mesh), receiver.model});
  lua_newtable(L);
  if (cast.filling != Filling::none && !append_outline(L, cast, {}, std::nullopt)) {
    // In parts, each of as many layers as 7 bits count. Their spans change while others are built.
    const auto found =
        source->layers.parts(light_as_drawn(*source, cast.model, light), most_layers);
    Cast by_faces = cast;
    by_faces.filling = Filling::faces;
    for (const shadow::Part& part : std::vector(found.begin(), found.end())) {
      if (!append_outline(L, cast, part.triangles, part.layers))
        append_outline(L, by_faces, part.triangles, part.layers);
    }
  }
  if (stage.explaining) {
    stage.explain(why(caster_name(L, 1), receiver.name, cast.filling, triangles_in(L),
                      source->builder.triangle_count()));
  }
  return 1;
}

int draw_outline(lua_State* L) {
  const Outline& outline = read_box<Outline>(L, 1, "an outline's draw: self");
  const Volume& volume = *outline.volume;
  draw_with({L, 2, 3}, volume.model, {}, volume.all, {}, "outline of a shadow",
            [&] { volume.drawn->draw(0, volume.all); });
  return 0;
}

constexpr Entry functions[] = {
    {"outlines", "shadow.outlines(mesh, model, light, receiver) -> { outline, … }",
     "What of a mesh, or of a scene's object (model may then be nil), to draw flattened onto a "
     "planar receiver, an object of the scene: its silhouette filled by triangles, whose faces of "
     "the two facings, counted up and down in the stencil, are not zero where the shadow is (of a "
     "light in its box: not -offset); or, with the receiver cutting its box, its own triangles "
     "that "
     "count. None where its shadow cannot meet the receiver, more than one where 7 bits may not "
     "count it.",
     guarded<outlines>},
};
constexpr Entry methods[] = {
    {"draw", "o:draw(shader, {view = , projection = , model = })",
     "Draws its triangles with the caster's model matrix, unless given another: "
     "shadow.planar(…) * the caster's.",
     guarded<draw_outline>},
};
constexpr std::string_view field_names[] = {"triangles", "layers", "offset"};

}  // namespace

bool BoxTraits<Outline>::push_field(lua_State* L, Outline& outline, std::string_view key) {
  if (key == "triangles") {
    lua_pushinteger(L, static_cast<lua_Integer>(outline.volume->all / 3));
  } else if (key == "layers") {
    lua_pushinteger(L, static_cast<lua_Integer>(outline.layers));
  } else if (key == "offset") {
    lua_pushinteger(L, outline.offset);
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<Outline>::fields() { return field_names; }

std::span<const Entry> outline_functions() { return functions; }
std::span<const Entry> outline_methods() { return methods; }
void open_outline(Stage& stage) { open_box<Outline>(stage.state.raw(), methods); }

}  // namespace shadowlab::lua
