// A frame under `run --plan`: what a recipe that knows of no plan draws more than its picture
// needs.
//
// A caster is left out where it is used, by a technique of which it is known when it changes
// nothing: shadow.parts and shadow.volume of a scene's object for a light whose volume reaches
// nothing that is seen, and draws of scene.caster, scene.objects and their like into a map that
// shadow.light_view, .cascades or .cube_faces gave, where no lookup can meet them. The scene itself
// stays as it is, so that what is fitted to its casters stays too, and the picture with it.
//
// The picture is taken to be the camera's for which the maps were asked, and else the scene's own.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "lua/boxes.h"
#include "shadow/light_view.h"
#include "shadow/map_needs.h"
#include "shadow/plan.h"

namespace shadowlab::lua {

class Planned {
 public:
  /// A map that the recipe was given this frame, and what was found that it needs.
  struct Map {
    SceneBox scene;  ///< with the camera that it is for
    glm::dvec4 light;
    glm::dmat4 view, projection;
    std::optional<shadow::DepthRange> part = std::nullopt;
    double reach = 0;  ///< of lookups beyond their filter, clip space
    int size = 0;      ///< texels, once that is known
    double filter = 0;
    std::optional<shadow::MapNeeds> needs = std::nullopt;
    bool skipped = false;  ///< the recipe was told that nobody reads it
    /// Of draws into it: casters, and those of them that were left out.
    std::size_t asked = 0, dropped = 0, triangles_saved = 0;
    std::int64_t pixels_saved = 0;  ///< at most; counted where somebody asks why
  };
  struct Volumes {
    SceneBox scene;
    glm::dvec4 light;
    shadow::Reasons reasons;
    shadow::Plan plan;
    /// Of its plan, those whose volume is left out where the recipe builds it. One whose lit sides
    /// alone are seen shadows nothing, but the recipe may count it there wrongly, and its picture
    /// is to stay what it is: it is kept.
    bool drops(std::size_t object) const;
  };

  void begin_frame();

  /// Whether the volume of this object for the light changes no pixel of the picture.
  bool drops(const ObjectBox& caster, const scene::Light& light, glm::ivec2 picture,
             shadow::Reasons reasons);
  /// What the scene's camera needs, found once a frame.
  const shadow::Plan& plan_of(const SceneBox& scene, glm::dvec4 light, glm::ivec2 picture,
                              shadow::Reasons reasons);

  /// A map that is read by what its scene's camera sees.
  Map& add_map(Map map);
  /// What it needs with lookups so many texels wide.
  const shadow::MapNeeds& needs_of(Map& map, int size, double filter, glm::ivec2 picture);
  /// For cube faces, which are asked for without a scene: whether the last range for this light was
  /// that of what is seen.
  void add_cube(const SceneBox& scene, glm::dvec4 light, bool in_view);
  void add_cube_faces(glm::dvec4 light, std::span<const shadow::LightView> faces);
  /// How a map of this projection is read: what shadow.map_bias was told. Whether anybody reads one
  /// of them: they are where it is not known what they are for.
  bool add_lookup(const glm::dmat4& projection, int size, double filter, glm::ivec2 picture);

  /// The map of these matrices, into which objects of `scene` are drawn; with what it needs, if it
  /// is known how it is read. Nothing where it is no map.
  Map* map_of(const SceneBox& scene, const glm::dmat4& view, const glm::dmat4& projection,
              glm::ivec2 picture);

  const std::deque<Map>& maps() const { return maps_; }
  const std::deque<Volumes>& volumes() const { return volumes_; }

 private:
  /// What the scene's camera sees, found once a frame.
  const shadow::Sight& sight_of(const SceneBox& scene, glm::ivec2 picture);
  const Volumes& volumes_of(const SceneBox& scene, glm::dvec4 light, glm::ivec2 picture,
                            shadow::Reasons reasons);

  struct Seen {
    SceneBox scene;
    glm::ivec2 picture;
    shadow::Sight sight;
  };
  struct Lookup {
    glm::dmat4 projection;
    int size;
    double filter;
  };
  struct Cube {
    SceneBox scene;
    glm::dvec4 light;
    bool in_view;
  };
  std::deque<Seen> seen_;
  std::deque<Volumes> volumes_;
  std::deque<Map> maps_;
  std::vector<Lookup> lookups_;
  std::vector<Cube> cubes_;
};

/// Whether object `index` is drawn into the map that the draw's table at stack index `uniforms` is
/// for: it is, unless the frame is planned and the map needs it not.
bool is_needed(lua_State* L, int uniforms, const SceneBox& scene, std::size_t index);

/// Whether the frame is planned, and needs not the volume for `light` of what is at `caster`: a
/// scene's object, under its own model matrix (nil at `model`).
bool is_dropped(lua_State* L, int caster, int model, const scene::Light& light);

}  // namespace shadowlab::lua
