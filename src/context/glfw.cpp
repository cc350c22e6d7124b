// A hidden window's context, for machines with a display. Main thread only, as GLFW asks.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

#include "context/native.h"

namespace shadowlab::context {
namespace {

struct Api {
  decltype(glfwInit)* init;
  decltype(glfwTerminate)* terminate;
  decltype(glfwGetError)* get_error;
  decltype(glfwDefaultWindowHints)* default_hints;
  decltype(glfwWindowHint)* hint;
  decltype(glfwCreateWindow)* create_window;
  decltype(glfwDestroyWindow)* destroy_window;
  decltype(glfwMakeContextCurrent)* make_current;
  decltype(glfwGetProcAddress)* get_function;

  Api() {
    const SharedLibrary library("GLFW", "libglfw.so.3", "libglfw3");
    library.find(init, "glfwInit");
    library.find(terminate, "glfwTerminate");
    library.find(get_error, "glfwGetError");
    library.find(default_hints, "glfwDefaultWindowHints");
    library.find(hint, "glfwWindowHint");
    library.find(create_window, "glfwCreateWindow");
    library.find(destroy_window, "glfwDestroyWindow");
    library.find(make_current, "glfwMakeContextCurrent");
    library.find(get_function, "glfwGetProcAddress");
  }

  std::string last_error() const {
    const char* description = nullptr;
    get_error(&description);
    return description ? description : "it does not say why";
  }
};

// GLFW is initialised while at least one of these exists. The count is GLFW's own state, mirrored:
// glfwTerminate ends every window whatever glfwInit was called before.
class Initialised {
 public:
  explicit Initialised(const Api& api) : api_(api) {
    if (!api_.init()) {
      throw Unavailable("GLFW: there is no display (" + api_.last_error() + ")",
                        "start it in a desktop, or with xvfb-run");
    }
    ++alive;
  }
  Initialised(const Initialised&) = delete;
  Initialised& operator=(const Initialised&) = delete;
  ~Initialised() {
    if (--alive == 0) api_.terminate();
  }

 private:
  static inline int alive = 0;
  const Api& api_;
};

class HiddenWindow final : public Native {
 public:
  explicit HiddenWindow(Size size) : initialised_(api_) {
    for (const int profile : {GLFW_OPENGL_COMPAT_PROFILE, GLFW_OPENGL_CORE_PROFILE}) {
      set_hints(profile);
      window_ = api_.create_window(size.width, size.height, "shadowlab", nullptr, nullptr);
      if (window_) return;
    }
    throw Unavailable("GLFW: no OpenGL 3.3 window (" + api_.last_error() + ")");
  }

  ~HiddenWindow() override { api_.destroy_window(window_); }

  void make_current() override {
    api_.make_current(window_);
    if (api_.get_error(nullptr) != GLFW_NO_ERROR) {
      throw Unavailable("GLFW: the context cannot be made current");
    }
  }

  void release() override { api_.make_current(nullptr); }

  Function function(const char* gl_name) const override { return api_.get_function(gl_name); }

  std::string name() const override { return "GLFW"; }

 private:
  void set_hints(int profile) const {
    api_.default_hints();
    api_.hint(GLFW_VISIBLE, GLFW_FALSE);
    api_.hint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    api_.hint(GLFW_CONTEXT_VERSION_MINOR, 3);
    api_.hint(GLFW_OPENGL_PROFILE, profile);
    api_.hint(GLFW_DEPTH_BITS, 24);
    api_.hint(GLFW_STENCIL_BITS, 8);
    for (const int channel : {GLFW_ACCUM_RED_BITS, GLFW_ACCUM_GREEN_BITS, GLFW_ACCUM_BLUE_BITS,
                              GLFW_ACCUM_ALPHA_BITS}) {
      api_.hint(channel, 16);
    }
  }

  Api api_;
  Initialised initialised_;
  GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<Native> make_glfw(Size size) { return std::make_unique<HiddenWindow>(size); }

}  // namespace shadowlab::context
