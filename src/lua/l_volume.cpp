// shadow.volume: building a caster's volume and drawing it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lua/boxes.h"
#include "lua/planned.h"
#include "lua/volume_pool.h"
#include "shadow/back.h"
#include "shadow/volume_lecture.h"

namespace shadowlab::lua {

namespace {

using shadow::Edges;

struct Options {
  Edges edges = Edges::silhouette;
  bool lecture = false;  // by the lecture's loop over faces
  shadow::Caps caps = shadow::Caps::both;
  double extrusion = shadow::infinite;
  std::size_t part = 0;  // counted from 1; 0: all
};

Options read_options(lua_State* L, int index) {
  Options options;
  if (lua_isnoneornil(L, index)) return options;
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError(
        "shadow.volume's options are a table, as { edges = \"silhouette\", caps = true }; it is " +
        describe(L, index));
  }
  static constexpr std::string_view names[] = {"edges", "caps", "extrude", "part"};
  lua_pushnil(L);
  while (lua_next(L, index)) {
    const std::string_view key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    const std::string_view text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    if (key == "edges") {
      options.lecture = text == "all" || text == "lit";
      options.edges = text == "all" ? Edges::all : text == "lit" ? Edges::lit : Edges::silhouette;
      if (!options.lecture && text != "silhouette") {
        throw InputError("shadow.volume: edges is \"all\", \"lit\" or \"silhouette\"; it is " +
                         (text.empty() ? describe(L, -1) : std::string(text)));
      }
    } else if (key == "caps") {
      options.caps = lua_toboolean(L, -1) ? shadow::Caps::both : shadow::Caps::none;
    } else if (key == "extrude") {
      if (text != "infinite") options.extrusion = read<double>(L, -1, "extrude");
      if (!(options.extrusion > 0))
        throw InputError("shadow.volume: extrude is \"infinite\" or a distance over 0");
    } else if (key == "part") {
      const double part = read<double>(L, -1, "part");
      if (!(part >= 1) || part != std::floor(part) || part > 1e9)
        throw InputError(
            "shadow.volume: part is a number from 1, of those that shadow.parts lists");
      options.part = static_cast<std::size_t>(part);
    } else {
      throw InputError(fmt::format("shadow.volume has no option {}{}",
                                   key.empty() ? describe(L, -2) : key, did_you_mean(key, names)));
    }
    lua_pop(L, 1);
  }
  return options;
}

std::unique_ptr<gl::VolumeBuffers> over_adjacency(gl::Graphics& graphics, VolumeSource& source) {
  if (!source.adjacency_vertices) {
    std::vector<glm::vec4> doubled;
    for (const glm::vec3& p : source.adjacency.positions) {
      doubled.emplace_back(p, 1);
      doubled.emplace_back(p, 0);
    }
    source.adjacency_vertices =
        std::make_shared<gl::VolumeVertices>(graphics.gl, graphics.calls(), doubled);
  }
  return std::make_unique<gl::VolumeBuffers>(graphics.gl, graphics.calls(),
                                             source.adjacency_vertices);
}

void build_by_lecture(gl::Graphics& graphics, Volume& volume, const Options& options) {
  VolumeSource& source = *volume.source;
  const auto mesh =
      shadow::volume_lecture(source.adjacency, source.next, volume.light, options.edges);
  if (!volume.lecture_buffers) volume.lecture_buffers = over_adjacency(graphics, source);
  volume.lecture_buffers->upload(mesh.indices);
  volume.drawn = volume.lecture_buffers.get();
  volume.sides = volume.all = mesh.indices.size();
}

// The triangles of which the camera sees the side that is turned from the light, as they are in the
// mesh: so they have the very depths that the scene has drawn. Both facings are exact. Of a box
// that hides its back the back is left out.
std::span<const std::uint32_t> unlit_sides(const Volume& volume, const glm::dmat4& view,
                                           const glm::dmat4& projection) {
  VolumeSource::Unlit& kept = volume.source->unlit;
  const shadow::FacingPlanes& faces = volume.source->builder.facing();
  const glm::dvec4 eye = shadow::light_in_model_space(volume.model, glm::inverse(view)[3]);
  const std::size_t first = volume.triangles.first;
  const std::size_t last = std::min(volume.triangles.last, faces.triangles().size());
  kept.toward_light.resize(last - first);
  kept.toward_eye.resize(last - first);
  faces.signs(volume.light, first, kept.toward_light);
  faces.signs(eye, first, kept.toward_eye);
  const bool front_alone =
      volume.source->solid_box &&
      shadow::hides_its_back(volume.source->bounds, projection * view * volume.model);
  kept.indices.clear();
  kept.indices.reserve(3 * (last - first));
  for (std::size_t i = first; i < last; ++i) {
    const auto& [a, b, c] = faces.triangles()[i];
    const std::int8_t toward_eye = kept.toward_eye[i - first];
    if (kept.toward_light[i - first] * toward_eye < 0 && (toward_eye > 0 || !front_alone))
      kept.indices.insert(kept.indices.end(), {2 * a, 2 * b, 2 * c});
  }
  return kept.indices;
}

std::string what_was_built(const std::string& caster, const Volume& volume,
                           const Options& options) {
  const std::string edges = options.lecture ? options.edges == Edges::all
                                                  ? "every edge of every face"
                                                  : "every edge of every lit face"
                                            : "the edges of its silhouette";
  const std::string caps = options.caps == shadow::Caps::none || options.lecture
                               ? "and no caps, which z-pass does without"
                               : fmt::format("and {} triangles of caps, which z-fail needs",
                                             (volume.all - volume.sides) / 3);
  return fmt::format(
      "The volume of {} is {} triangles from {}, extruded {}, {}.", caster, volume.sides / 3, edges,
      volume.extrusion > 0 ? fmt::format("by {:g} m", volume.extrusion) : "to infinity", caps);
}

int build(lua_State* L) {
  const MeshBox mesh = caster_mesh(L, 1, "volume");
  const glm::dmat4 model = caster_model(L, 2, "volume");
  const auto light = read_light(L, 3, "argument 3 of shadow.volume (the light)");
  const Options options = read_options(L, 4);
  Stage& stage = Stage::of(L);
  stage.state.check_budget(mesh->indices.size());
  VolumeBox& volume = stage.volumes->next(mesh);
  volume->model = model;
  volume->light = light_as_drawn(*volume->source, model, light);
  volume->extrusion = std::isinf(options.extrusion) ? 0 : options.extrusion;
  volume->triangles =
      options.lecture || options.part == 0
          ? shadow::TriangleRange{}
          : part_of(*volume->source, volume->light, static_cast<double>(options.part), "volume");
  const bool dropped = is_dropped(L, 1, 2, light);
  if (dropped) {
    volume->triangles = {0, 0};
    volume->drawn = volume->buffers.get();
    volume->sides = volume->all = 0;
  } else if (options.lecture) {
    build_by_lecture(stage.graphics, *volume, options);
  } else {
    shadow::VolumeOptions how;
    how.caps = options.caps;
    how.reach = volume->extrusion > 0 ? shadow::Reach::finite : shadow::Reach::infinite;
    how.handedness = glm::determinant(glm::dmat3(model)) < 0 ? shadow::Handedness::mirrored
                                                             : shadow::Handedness::kept;
    how.triangles = volume->triangles;
    const auto indices = volume->source->builder.build(volume->light, how);
    volume->buffers->upload(indices.all);
    volume->drawn = volume->buffers.get();
    volume->sides = indices.sides.size();
    volume->all = indices.all.size();
  }
  if (stage.explaining && !dropped)
    stage.explain(what_was_built(caster_name(L, 1), *volume, options));
  push_box<VolumeBox>(L, volume);
  return 1;
}

enum class Part { all, sides };

void draw_volume(lua_State* L, Part part) {
  VolumeBox& volume = read_box<VolumeBox>(L, 1, "a volume's draw: self");
  const std::size_t count = part == Part::all ? volume->all : volume->sides;
  const glm::dvec4& light = volume->light;
  const Derived derived[] = {{"volume_light", {light.x, light.y, light.z, light.w}},
                             {"volume_extrusion", {volume->extrusion}}};
  draw_with({L, 2, 3}, volume->model, {}, count, derived,
            part == Part::all ? "shadow volume" : "sides of a shadow volume",
            [&] { volume->drawn->draw(0, count); });
}

int draw_all(lua_State* L) {
  draw_volume(L, Part::all);
  return 0;
}

int draw_sides(lua_State* L) {
  draw_volume(L, Part::sides);
  return 0;
}

int draw_unlit(lua_State* L) {
  VolumeBox& volume = read_box<VolumeBox>(L, 1, "volume:draw_unlit: self");
  if (!volume->unlit_buffers) {
    gl::Graphics& graphics = Stage::of(L).graphics;
    volume->unlit_buffers = std::make_unique<gl::VolumeBuffers>(graphics.gl, graphics.calls(),
                                                                volume->source->vertices);
  }
  glm::dmat4 view(1), projection(1);
  if (lua_type(L, 3) == LUA_TTABLE) {
    if (lua_getfield(L, 3, "view") != LUA_TNIL) view = read<glm::dmat4>(L, -1, "view");
    if (lua_getfield(L, 3, "projection") != LUA_TNIL)
      projection = read<glm::dmat4>(L, -1, "projection");
    lua_pop(L, 2);
  }
  const auto indices = unlit_sides(*volume, view, projection);
  volume->unlit_buffers->upload(indices);
  draw_with({L, 2, 3}, volume->model, {}, indices.size(), {}, "sides turned from the light",
            [&] { volume->unlit_buffers->draw(0, indices.size()); });
  return 0;
}

constexpr Entry functions[] = {
    {"volume",
     "shadow.volume(mesh, model, light, {edges = \"all\"|\"lit\"|\"silhouette\", caps = true, "
     "extrude = \"infinite\"|distance, part = }) -> volume",
     "The shadow volume of a mesh, or of a scene's object (model may then be nil). The three edges "
     "are the lecture's stages: wrong, better, right. Draw it with a shader whose vertex stage "
     "extrudes, as shader.load \"volume\".",
     guarded<build>},
};
constexpr Entry methods[] = {
    {"draw", "v:draw(shader, {view = , projection = })",
     "Draws sides and caps: what z-fail counts.", guarded<draw_all>},
    {"draw_sides", "v:draw_sides(shader, {view = , projection = })",
     "Draws the sides alone: what z-pass counts.", guarded<draw_sides>},
    {"draw_unlit", "v:draw_unlit(shader, {view = , projection = })",
     "Draws the caster's own triangles of which the camera sees the side that is turned from the "
     "light: those are in their own shadow, exactly.",
     guarded<draw_unlit>},
};
constexpr std::string_view field_names[] = {"triangles", "side_triangles"};

}  // namespace

bool BoxTraits<VolumeBox>::push_field(lua_State* L, VolumeBox& volume, std::string_view key) {
  if (key == "triangles") {
    lua_pushinteger(L, static_cast<lua_Integer>(volume->all / 3));
  } else if (key == "side_triangles") {
    lua_pushinteger(L, static_cast<lua_Integer>(volume->sides / 3));
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<VolumeBox>::fields() { return field_names; }

std::span<const Entry> volume_functions() { return functions; }
std::span<const Entry> volume_methods() { return methods; }

void open_volume(Stage& stage) {
  lua_State* L = stage.state.raw();
  stage.volumes = std::make_shared<VolumePool>(stage.graphics);
  open_box<VolumeBox>(L, methods);
}

}  // namespace shadowlab::lua
