// EGL without a window: a GPU's device where there is one, else Mesa's surfaceless platform.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "context/native.h"

namespace shadowlab::context {
namespace {

struct Api {
  decltype(eglGetProcAddress)* get_function;
  decltype(eglQueryString)* query_string;
  decltype(eglInitialize)* initialize;
  decltype(eglBindAPI)* bind_api;
  decltype(eglChooseConfig)* choose_config;
  decltype(eglCreateContext)* create_context;
  decltype(eglDestroyContext)* destroy_context;
  decltype(eglCreatePbufferSurface)* create_pbuffer;
  decltype(eglDestroySurface)* destroy_surface;
  decltype(eglMakeCurrent)* make_current;

  Api() {
    const SharedLibrary library("EGL", "libEGL.so.1", "libegl1");
    library.find(get_function, "eglGetProcAddress");
    library.find(query_string, "eglQueryString");
    library.find(initialize, "eglInitialize");
    library.find(bind_api, "eglBindAPI");
    library.find(choose_config, "eglChooseConfig");
    library.find(create_context, "eglCreateContext");
    library.find(destroy_context, "eglDestroyContext");
    library.find(create_pbuffer, "eglCreatePbufferSurface");
    library.find(destroy_surface, "eglDestroySurface");
    library.find(make_current, "eglMakeCurrent");
  }

  template <typename F>
  F extension(const char* name) const {
    return reinterpret_cast<F>(get_function(name));
  }
};

// `list` is separated by spaces; null where EGL could not answer.
bool lists(const char* list, std::string_view extension) {
  std::string_view rest = list ? list : "";
  for (std::size_t at = rest.find(extension); at != std::string_view::npos;
       at = rest.find(extension, at + 1)) {
    const std::size_t end = at + extension.size();
    const bool begins = at == 0 || rest[at - 1] == ' ';
    if (begins && (end == rest.size() || rest[end] == ' ')) return true;
  }
  return false;
}

// A display is the process's, shared by every context on it and by other users of EGL, so it is
// never terminated: that would end their contexts.
struct Display {
  EGLDisplay display;
  EGLenum platform;
};

struct Devices {
  std::vector<EGLDeviceEXT> gpus;
  std::vector<EGLDeviceEXT> software;
};

Devices find_devices(const Api& api, const char* client_extensions) {
  Devices devices;
  const bool enumerates = lists(client_extensions, "EGL_EXT_device_base") ||
                          lists(client_extensions, "EGL_EXT_device_enumeration");
  const auto query = api.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto string = api.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!enumerates || !lists(client_extensions, "EGL_EXT_platform_device") || !query || !string) {
    return devices;
  }
  EGLint count = 0;
  if (!query(0, nullptr, &count) || count <= 0) return devices;
  std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
  if (!query(count, found.data(), &count)) return devices;
  found.resize(static_cast<std::size_t>(count));
  for (const EGLDeviceEXT device : found) {
    const bool software = lists(string(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    (software ? devices.software : devices.gpus).push_back(device);
  }
  return devices;
}

// In the order in which they are tried.
std::vector<Display> find_displays(const Api& api) {
  const char* extensions = api.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto get = api.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!lists(extensions, "EGL_EXT_platform_base") || !get) return {};
  std::vector<Display> displays;
  const auto add = [&](EGLenum platform, void* native) {
    const EGLDisplay display = get(platform, native, nullptr);
    if (display != EGL_NO_DISPLAY) displays.push_back({display, platform});
  };
  const Devices devices = find_devices(api, extensions);
  for (EGLDeviceEXT gpu : devices.gpus) add(EGL_PLATFORM_DEVICE_EXT, gpu);
  if (lists(extensions, "EGL_MESA_platform_surfaceless")) {
    add(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  }
  for (EGLDeviceEXT cpu : devices.software) add(EGL_PLATFORM_DEVICE_EXT, cpu);
  return displays;
}

class Egl final : public Native {
 public:
  // Null where this display cannot give an OpenGL 3.3 context that works.
  static std::unique_ptr<Egl> on(const Api& api, const Display& display, Size size) {
    if (!api.initialize(display.display, nullptr, nullptr) || !api.bind_api(EGL_OPENGL_API)) {
      return nullptr;
    }
    std::unique_ptr<Egl> egl(new Egl(api, display));
    if (!egl->choose_surface(size) || !egl->create_context() || !egl->try_make_current()) {
      return nullptr;
    }
    egl->release();
    return egl;
  }

  ~Egl() override {
    release();
    if (context_ != EGL_NO_CONTEXT) api_.destroy_context(display_.display, context_);
    if (surface_ != EGL_NO_SURFACE) api_.destroy_surface(display_.display, surface_);
  }

  void make_current() override {
    if (!try_make_current()) throw Unavailable("EGL: the context cannot be made current");
  }

  void release() override {
    api_.bind_api(EGL_OPENGL_API);
    api_.make_current(display_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

  Function function(const char* gl_name) const override { return api_.get_function(gl_name); }

  std::string name() const override {
    if (display_.platform == EGL_PLATFORM_SURFACELESS_MESA) return "EGL surfaceless";
    constexpr unsigned renderer = 0x1F01;  // GL_RENDERER
    const auto get =
        reinterpret_cast<const unsigned char* (*)(unsigned)>(api_.get_function("glGetString"));
    const unsigned char* found = get ? get(renderer) : nullptr;
    std::string name = "EGL device ";
    name += found ? reinterpret_cast<const char*>(found) : "of no name";
    return name;
  }

 private:
  Egl(const Api& api, const Display& display) : api_(api), display_(display) {}

  // The bound API is the thread's, and OpenGL ES is EGL's default.
  bool try_make_current() {
    return api_.bind_api(EGL_OPENGL_API) &&
           api_.make_current(display_.display, surface_, surface_, context_);
  }

  // Nothing at all where EGL allows it; else a buffer of that size that nobody draws to.
  bool choose_surface(Size size) {
    const char* extensions = api_.query_string(display_.display, EGL_EXTENSIONS);
    if (lists(extensions, "EGL_KHR_surfaceless_context") &&
        lists(extensions, "EGL_KHR_no_config_context")) {
      return true;
    }
    const std::array<EGLint, 9> wanted = {EGL_SURFACE_TYPE,
                                          EGL_PBUFFER_BIT,
                                          EGL_RENDERABLE_TYPE,
                                          EGL_OPENGL_BIT,
                                          EGL_DEPTH_SIZE,
                                          24,
                                          EGL_STENCIL_SIZE,
                                          8,
                                          EGL_NONE};
    EGLint count = 0;
    if (!api_.choose_config(display_.display, wanted.data(), &config_, 1, &count) || count < 1) {
      return false;
    }
    const std::array<EGLint, 5> shape = {EGL_WIDTH, size.width, EGL_HEIGHT, size.height, EGL_NONE};
    surface_ = api_.create_pbuffer(display_.display, config_, shape.data());
    return surface_ != EGL_NO_SURFACE;
  }

  bool create_context() {
    for (const EGLint profile :
         {EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT}) {
      const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                profile,
                                                EGL_NONE};
      context_ = api_.create_context(display_.display, config_, EGL_NO_CONTEXT, attributes.data());
      if (context_ != EGL_NO_CONTEXT) return true;
    }
    return false;
  }

  Api api_;
  Display display_;
  EGLConfig config_ = nullptr;  // EGL_NO_CONFIG_KHR
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Native> make_egl(Size size) {
  const Api api;
  const std::vector<Display> displays = find_displays(api);
  for (const Display& display : displays) {
    if (auto egl = Egl::on(api, display, size)) return egl;
  }
  throw Unavailable("EGL: none of its " + std::to_string(displays.size()) +
                        " devices and platforms gives an OpenGL 3.3 context",
                    "install Mesa's drivers with apt-get install libegl-mesa0 libgl1-mesa-dri");
}

}  // namespace shadowlab::context
