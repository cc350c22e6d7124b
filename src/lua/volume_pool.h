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
#include "lua/box.h"
#include "lua/stage.h"
#include "scene/adjacency.h"
#include "shadow/facing.h"
#include "shadow/volume.h"

namespace shadowlab::lua {

/// What does not change with the light: one for each mesh.
struct VolumeSource {
  VolumeSource(gl::Graphics& graphics, const scene::Mesh& mesh);

  scene::Adjacency adjacency;
  std::vector<std::array<std::int32_t, 3>> next;
  std::size_t layers;  ///< see shadow::layers
  shadow::FacingPlanes facing;
  shadow::VolumeBuilder builder;
  std::shared_ptr<gl::VolumeVertices> vertices;  ///< the builder's
  /// The adjacency's vertices, doubled; made when asked for.
  std::shared_ptr<gl::VolumeVertices> adjacency_vertices;
};

/// One volume as drawn: its indices, and the light and model that it was built for.
struct Volume {
  std::shared_ptr<VolumeSource> source;
  std::unique_ptr<gl::VolumeBuffers> buffers;          ///< over source->vertices
  std::unique_ptr<gl::VolumeBuffers> lecture_buffers;  ///< over source->adjacency_vertices
  std::unique_ptr<gl::VolumeBuffers> unlit_buffers;    ///< the same
  const gl::VolumeBuffers* drawn = nullptr;
  std::size_t sides = 0;  ///< indices of the sides, the first
  std::size_t all = 0;
  glm::dmat4 model{1};
  glm::dvec4 light{0};   ///< model space, of floats
  double extrusion = 0;  ///< metres; 0: to infinity
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

/// shadow.volume and its like, for the table of shadow.*; and their methods.
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
