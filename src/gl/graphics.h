// A GL context and all that the core keeps in it.
#pragma once

#include <memory>
#include <vector>

#include "context/context.h"
#include "gl/accumulation.h"
#include "gl/main_frame.h"
#include "gl/mesh_buffers.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/vertex_input.h"

namespace shadowlab::gl {

/// Everything GL of one context: the function table, the main frame, programs, meshes, the
/// accumulation buffer and the objects that a recipe made. Two can live side by side; the calls go
/// to the context that is current (`context.make_current()`).
class Graphics {
  // Declared first, destroyed last: the others delete their objects in it.
  context::Context context_;
  CallContext calls_{&context_};

 public:
  Graphics(context::Context context, int width, int height);
  ~Graphics();
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  const context::Context& context() const { return context_; }
  int width() const { return frame.width(); }
  int height() const { return frame.height(); }

  /// Traces the calls from now on into `recorder`; nullptr stops.
  void trace_into(Recorder* recorder) { calls_.recorder = recorder; }
  Recorder* recorder() const { return calls_.recorder; }
  CallContext& calls() { return calls_; }

  /// GL's defaults, every frame: state, uniforms, accumulation storage.
  void begin_frame();

  /// A shader over a cached program. Its uniforms are reset at each frame's begin.
  std::shared_ptr<Shader> make_shader(const ProgramSource& source);

  /// The values that shaders hold now are those that frames begin with: called after setup.
  void keep_uniforms();

  /// Deletes what a recipe made; for the next recipe in this context.
  void forget(Objects& objects);

  /// Deletes the program now, or at the next frame's begin where it is in use.
  void delete_when_unused(GLuint program);

  /// A main frame of another size, cleared. What recipes made for the size before is theirs to
  /// make anew: between frames, for a recipe that is set up afterwards.
  void resize(int width, int height);

  /// The main frame and the accumulation buffer as in a new context: nothing is left of what
  /// another recipe drew. Called at a frame's begin.
  void clear_buffers();

  const Functions gl;
  MainFrame frame;
  ProgramCache programs;
  Accumulation accumulation;
  MeshCache meshes;
  VertexInput vertices;

 private:
  std::vector<std::weak_ptr<Shader>> shaders_;
  std::vector<GLuint> deleted_in_use_;  ///< programs
};

}  // namespace shadowlab::gl
