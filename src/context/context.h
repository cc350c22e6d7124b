// A GL context without a word about where it comes from.
//
// One struct, filled at the end of creation by whichever backend makes it (osmesa.cpp, egl.cpp,
// glfw.cpp: the only files that name a window system). Libraries are loaded when a backend is asked
// for, so a program needs none of them to start.
//
//   context::Context c = context::create(context::Backend::automatic);
//   auto clear = reinterpret_cast<PFNGLCLEARPROC>(c.function("glClear"));
//
// Not here: the frame that recipes draw to (a framebuffer object: gl/), function tables (gl/).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::context {

/// `automatic` is OSMesa, else EGL, else GLFW: the first that works.
enum class Backend { automatic, osmesa, egl, glfw };

/// The backend's name on the command line: "osmesa", "egl", "glfw", "automatic".
std::string_view name_of(Backend backend);
/// The backend of that name. Throws InputError for any other word.
Backend backend_named(std::string_view name);

/// A GL function of unknown type: cast it to its PFNGL…PROC.
using Function = void (*)();

/// Pixels of a context's own default framebuffer. EGL's surfaceless contexts have none whatever is
/// asked for.
struct Size {
  int width = 16;
  int height = 16;
};

class Native;
class Window;
struct WindowOptions;

/// A GL context: 3.3 or later, in the compatibility profile where the driver has it, else core.
/// Several may live side by side; at most one is current on a thread, and a context is current on
/// at most one thread. It must be destroyed on the thread where it is current, or where none is.
struct Context {
  Context(Context&& other) noexcept;
  Context& operator=(Context&& other) noexcept;
  ~Context();

  Backend backend;       ///< never `automatic`
  std::string name;      ///< "OSMesa", "EGL surfaceless", "EGL device NVIDIA …", "GLFW"
  std::string version;   ///< GL_VERSION
  std::string renderer;  ///< GL_RENDERER
  std::string vendor;    ///< GL_VENDOR
  int major = 0;         ///< GL_MAJOR_VERSION
  int minor = 0;         ///< GL_MINOR_VERSION
  /// Bits of the context's own default framebuffer; 0 where it has none.
  int depth_bits = 0;
  int stencil_bits = 0;
  int accum_bits = 0;  ///< of one channel

  /// The GL function of that name ("glClear"), or null where this context has none; EGL and GLX
  /// give a stub for names that no GL has. Valid while this context is current, and only there:
  /// OSMesa's and libGL's functions of one name differ.
  Function function(const char* gl_name) const;
  /// Makes this context the calling thread's, in place of whichever was. Throws MachineError.
  void make_current() const;
  /// Leaves the calling thread without a context, if this is its context.
  void release() const;
  /// The window of a context that create_window made (window.h); null for any other.
  Window* window() const;

 private:
  friend Context create(Backend, Size);
  friend Context create_window(const WindowOptions&);
  Context(Backend made_by, std::unique_ptr<Native> native);

  std::unique_ptr<Native> native_;
};

/// Makes a context and makes it current. Throws MachineError, one plain sentence that says what is
/// missing and what to install; with `automatic`, why none of the three works. GLFW only on the
/// main thread.
Context create(Backend backend = Backend::automatic, Size size = {});

/// What one backend does on this machine.
struct Report {
  Backend backend;
  bool works = false;
  std::string name;     ///< as Context::name; "OSMesa", "EGL", "GLFW" where it does not work
  std::string why_not;  ///< a plain sentence; empty where it works
  std::string package;  ///< the Debian package that provides it
  std::string version;  ///< empty where it does not work, as below
  std::string renderer;
  int depth_bits = 0;
  int stencil_bits = 0;
  int accum_bits = 0;
};

/// Tries each backend in turn (a fraction of a second) and leaves the thread without a context.
std::vector<Report> survey();

}  // namespace shadowlab::context
