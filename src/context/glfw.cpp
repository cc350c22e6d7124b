// Windows' contexts, for machines with a display; a hidden one is a context alone.
#include "context/glfw.h"

namespace shadowlab::context {

Glfw::Glfw() {
  const SharedLibrary library("GLFW", "libglfw.so.3", "libglfw3");
  library.find(init, "glfwInit");
  library.find(terminate, "glfwTerminate");
  library.find(get_error, "glfwGetError");
  library.find(default_hints, "glfwDefaultWindowHints");
  library.find(hint, "glfwWindowHint");
  library.find(extension_supported, "glfwExtensionSupported");
  library.find(create_window, "glfwCreateWindow");
  library.find(destroy_window, "glfwDestroyWindow");
  library.find(make_current, "glfwMakeContextCurrent");
  library.find(get_function, "glfwGetProcAddress");
  library.find(swap_interval, "glfwSwapInterval");
  library.find(swap_buffers, "glfwSwapBuffers");
  library.find(poll_events, "glfwPollEvents");
  library.find(wait_events, "glfwWaitEventsTimeout");
  library.find(framebuffer_size, "glfwGetFramebufferSize");
  library.find(window_size, "glfwGetWindowSize");
  library.find(set_window_size, "glfwSetWindowSize");
  library.find(window_position, "glfwGetWindowPos");
  library.find(content_scale, "glfwGetWindowContentScale");
  library.find(window_attribute, "glfwGetWindowAttrib");
  library.find(set_title, "glfwSetWindowTitle");
  library.find(set_monitor, "glfwSetWindowMonitor");
  library.find(window_monitor, "glfwGetWindowMonitor");
  library.find(monitors, "glfwGetMonitors");
  library.find(monitor_position, "glfwGetMonitorPos");
  library.find(video_mode, "glfwGetVideoMode");
  library.find(key_name, "glfwGetKeyName");
  library.find(key_state, "glfwGetKey");
  library.find(set_user_pointer, "glfwSetWindowUserPointer");
  library.find(user_pointer, "glfwGetWindowUserPointer");
  library.find(on_key, "glfwSetKeyCallback");
  library.find(on_character, "glfwSetCharCallback");
  library.find(on_pointer, "glfwSetCursorPosCallback");
  library.find(on_enter, "glfwSetCursorEnterCallback");
  library.find(on_button, "glfwSetMouseButtonCallback");
  library.find(on_scroll, "glfwSetScrollCallback");
  library.find(on_focus, "glfwSetWindowFocusCallback");
  library.find(on_close, "glfwSetWindowCloseCallback");
}

std::string Glfw::last_error() const {
  const char* description = nullptr;
  get_error(&description);
  return description ? description : "it does not say why";
}

GlfwInitialised::GlfwInitialised(const Glfw& glfw) : glfw_(glfw) {
  if (!glfw_.init()) {
    throw Unavailable("GLFW: there is no display (" + glfw_.last_error() + ")",
                      "start it in a desktop, or with xvfb-run");
  }
  ++alive;
}

GlfwInitialised::~GlfwInitialised() {
  if (--alive == 0) glfw_.terminate();
}

GlfwContext::GlfwContext(Size size, const std::string& title, Shown shown) : initialised_(glfw_) {
  for (const int profile : {GLFW_OPENGL_COMPAT_PROFILE, GLFW_OPENGL_CORE_PROFILE}) {
    set_hints(profile, shown);
    window_ = glfw_.create_window(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (window_) return;
  }
  throw Unavailable("GLFW: no OpenGL 3.3 window (" + glfw_.last_error() + ")");
}

GlfwContext::~GlfwContext() { glfw_.destroy_window(window_); }

void GlfwContext::make_current() {
  glfw_.make_current(window_);
  if (glfw_.get_error(nullptr) != GLFW_NO_ERROR) {
    throw Unavailable("GLFW: the context cannot be made current");
  }
}

void GlfwContext::release() { glfw_.make_current(nullptr); }

Function GlfwContext::function(const char* gl_name) const { return glfw_.get_function(gl_name); }

void GlfwContext::set_hints(int profile, Shown shown) const {
  glfw_.default_hints();
  glfw_.hint(GLFW_VISIBLE, shown == Shown::yes ? GLFW_TRUE : GLFW_FALSE);
  glfw_.hint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfw_.hint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfw_.hint(GLFW_OPENGL_PROFILE, profile);
  // Only such a context tells that it was lost; drivers without them give a plain one.
  if (shown == Shown::yes) {
    glfw_.hint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfw_.hint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  }
  // A window that is looked at shows pictures, and needs nothing but colour.
  glfw_.hint(GLFW_DEPTH_BITS, shown == Shown::yes ? 0 : 24);
  glfw_.hint(GLFW_STENCIL_BITS, shown == Shown::yes ? 0 : 8);
  for (const int channel :
       {GLFW_ACCUM_RED_BITS, GLFW_ACCUM_GREEN_BITS, GLFW_ACCUM_BLUE_BITS, GLFW_ACCUM_ALPHA_BITS}) {
    glfw_.hint(channel, shown == Shown::yes ? 0 : 16);
  }
}

std::unique_ptr<Native> make_glfw(Size size) {
  return std::make_unique<GlfwContext>(size, "shadowlab", GlfwContext::Shown::no);
}

}  // namespace shadowlab::context
