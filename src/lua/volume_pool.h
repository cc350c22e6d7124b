// The volumes of a recipe, kept from frame to frame.
//
// shadow.volume is a function of mesh, model, light and options; so that nothing is allocated in a
// frame after the first, the n-th volume that a frame asks of a mesh takes the place of the n-th of
// the frame before. What setup asked for stays.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "gl/graphics.h"
#include "gl/volume_buffers.h"
#include "lua/boxes.h"
#include "lua/stage.h"
#include "scene/adjacency.h"
#include "shadow/extrusion.h"
#include "shadow/facing.h"
#include "shadow/layers.h"
#include "shadow/volume.h"

namespace shadowlab::lua {

/// What does not change with the light: one for each mesh.
struct VolumeSource {
  VolumeSource(gl::Graphics& graphics, const scene::Mesh& mesh);

  scene::Bounds bounds;
  bool solid_box;  ///< shadow::is_solid_box
  scene::Adjacency adjacency;
  std::vector<std::array<std::int32_t, 3>> next;
  shadow::FacingPlanes facing;
  shadow::VolumeBuilder builder;
  shadow::Layers layers;
  std::shared_ptr<gl::VolumeVertices> vertices;  ///< the builder's
  /// The adjacency's vertices, doubled; made when asked for.
  std::shared_ptr<gl::VolumeVertices> adjacency_vertices;

  /// Of the last draw_unlit; its vectors keep their storage from frame to frame.
  struct Unlit {
    std::vector<std::int8_t> toward_light, toward_eye;
    std::vector<std::uint32_t> indices;
  };
  Unlit unlit;

  /// What shaders extrude by themselves, of a run of the builder's triangles.
  class Extrudable {
   public:
    explicit Extrudable(State& state) : state_(state) {}
    ~Extrudable() { state_.release(reserved_); }
    Extrudable(const Extrudable&) = delete;
    Extrudable& operator=(const Extrudable&) = delete;
    /// Counts memory that the script holds by it. Throws InputError past the cap.
    void reserve(std::size_t bytes) {
      state_.reserve(bytes);
      reserved_ += bytes;
    }
    std::unique_ptr<gl::FixedElements> doubled;   ///< for the vertex shader
    std::unique_ptr<gl::FixedElements> separate;  ///< the triangles alone, for the same
    std::unique_ptr<gl::FixedElements> adjacent;  ///< for the geometry shader

   private:
    State& state_;
    std::size_t reserved_ = 0;
  };
  /// By the run's first and last; each made when asked for.
  std::map<std::pair<std::size_t, std::size_t>, std::shared_ptr<Extrudable>> extrudables;
};

/// A caster whose volume shaders make: nothing of it changes with the light.
struct Extrusion {
  enum class Stage { vertex, geometry };
  std::shared_ptr<VolumeSource> source;
  std::shared_ptr<VolumeSource::Extrudable> elements;
  shadow::TriangleRange triangles;
  Stage stage = Stage::vertex;
  glm::dmat4 model{1};
};

/// One volume as drawn: its indices, and the light and model that it was built for.
struct Volume {
  std::shared_ptr<VolumeSource> source;
  std::unique_ptr<gl::VolumeBuffers> buffers;          ///< over source->vertices
  std::unique_ptr<gl::VolumeBuffers> lecture_buffers;  ///< over source->adjacency_vertices
  std::unique_ptr<gl::VolumeBuffers> unlit_buffers;    ///< over source->vertices
  const gl::VolumeBuffers* drawn = nullptr;
  std::size_t sides = 0;  ///< indices of the sides, the first
  std::size_t all = 0;
  glm::dmat4 model{1};
  glm::dvec4 light{0};              ///< model space, of floats
  shadow::TriangleRange triangles;  ///< the part's
  double extrusion = 0;             ///< metres; 0: to infinity
};
using VolumeBox = std::shared_ptr<Volume>;

class VolumePool {
 public:
  explicit VolumePool(gl::Graphics& graphics) : graphics_(graphics) {}

  std::shared_ptr<VolumeSource> source(const std::shared_ptr<const scene::Mesh>& mesh);
  /// The mesh's next volume of this frame.
  VolumeBox& next(const std::shared_ptr<const scene::Mesh>& mesh);
  /// Volumes that exist already are kept by whoever asked for them.
  void keep_all();
  void begin_frame();

 private:
  struct Entry {
    std::weak_ptr<const scene::Mesh> mesh;
    std::shared_ptr<VolumeSource> source;
    std::vector<VolumeBox> volumes;
    std::size_t used = 0;
  };
  Entry& entry(const std::shared_ptr<const scene::Mesh>& mesh);

  gl::Graphics& graphics_;
  std::map<const scene::Mesh*, Entry> entries_;
};

template <>
struct BoxTraits<Extrusion> {
  static constexpr const char* name = "extrusion";
  static bool push_field(lua_State*, Extrusion&, std::string_view);
  static std::span<const std::string_view> fields();
};
/// A volume's place in the pool, for what is flattened of its caster.
struct Outline {
  VolumeBox volume;
  std::size_t layers = 0;  ///< no point is counted more often
  int offset = 0;          ///< to be added to what it counts
};

template <>
struct BoxTraits<Outline> {
  static constexpr const char* name = "outline";
  static bool push_field(lua_State*, Outline&, std::string_view);
  static std::span<const std::string_view> fields();
};
std::span<const Entry> outline_functions();
std::span<const Entry> outline_methods();
void open_outline(Stage& stage);

std::span<const Entry> extrusion_functions();
std::span<const Entry> extrusion_methods();
void open_extrusion(Stage& stage);

/// The mesh, or the mesh of the object, that argument `index` of shadow.`function` is.
MeshBox caster_mesh(lua_State* L, int index, const char* function);
/// The model matrix at `index`; nil is that of the object which argument 1 is, or none.
glm::dmat4 caster_model(lua_State* L, int index, const char* function);

/// What an explanation calls the mesh or object at `index`.
std::string caster_name(lua_State* L, int index);
/// The light in the caster's space, as the very floats that the shader extrudes from: so that its
/// sides and what is decided here agree; beside the faces that it lies on.
glm::dvec4 light_as_drawn(const VolumeSource& source, const glm::dmat4& model,
                          const scene::Light& light);

/// The triangles of part `part` of shadow.parts, counted from 1, for a light as drawn. Throws
/// InputError, naming shadow.`function`, where there is none.
shadow::TriangleRange part_of(VolumeSource& source, glm::dvec4 light, double part,
                              const char* function);

/// shadow.needs_zfail, .parts, .adjacency and .silhouette.
std::span<const Entry> silhouette_functions();

/// shadow.volume, for the table of shadow.*; and its methods.
std::span<const Entry> volume_functions();
std::span<const Entry> volume_methods();
/// The stage's pool and the metatable of volumes; once for a state.
void open_volume(Stage& stage);

template <>
struct BoxTraits<VolumeBox> {
  static constexpr const char* name = "shadow volume";
  static bool push_field(lua_State*, VolumeBox&, std::string_view);
  static std::span<const std::string_view> fields();
};

}  // namespace shadowlab::lua
