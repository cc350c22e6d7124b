// GLFW, loaded at run time: internal to this floor.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

#include "context/native.h"

namespace shadowlab::context {

/// The functions of GLFW that we call.
struct Glfw {
  decltype(glfwInit)* init;
  decltype(glfwTerminate)* terminate;
  decltype(glfwGetError)* get_error;
  decltype(glfwDefaultWindowHints)* default_hints;
  decltype(glfwWindowHint)* hint;
  decltype(glfwExtensionSupported)* extension_supported;
  decltype(glfwCreateWindow)* create_window;
  decltype(glfwDestroyWindow)* destroy_window;
  decltype(glfwMakeContextCurrent)* make_current;
  decltype(glfwGetProcAddress)* get_function;
  decltype(glfwSwapInterval)* swap_interval;
  decltype(glfwSwapBuffers)* swap_buffers;
  decltype(glfwPollEvents)* poll_events;
  decltype(glfwWaitEventsTimeout)* wait_events;
  decltype(glfwGetFramebufferSize)* framebuffer_size;
  decltype(glfwGetWindowSize)* window_size;
  decltype(glfwSetWindowSize)* set_window_size;
  decltype(glfwGetWindowPos)* window_position;
  decltype(glfwGetWindowContentScale)* content_scale;
  decltype(glfwGetWindowAttrib)* window_attribute;
  decltype(glfwSetWindowTitle)* set_title;
  decltype(glfwSetWindowMonitor)* set_monitor;
  decltype(glfwGetWindowMonitor)* window_monitor;
  decltype(glfwGetMonitors)* monitors;
  decltype(glfwGetMonitorPos)* monitor_position;
  decltype(glfwGetVideoMode)* video_mode;
  decltype(glfwGetKeyName)* key_name;
  decltype(glfwGetKey)* key_state;
  decltype(glfwSetWindowUserPointer)* set_user_pointer;
  decltype(glfwGetWindowUserPointer)* user_pointer;
  decltype(glfwSetKeyCallback)* on_key;
  decltype(glfwSetCharCallback)* on_character;
  decltype(glfwSetCursorPosCallback)* on_pointer;
  decltype(glfwSetCursorEnterCallback)* on_enter;
  decltype(glfwSetMouseButtonCallback)* on_button;
  decltype(glfwSetScrollCallback)* on_scroll;
  decltype(glfwSetWindowFocusCallback)* on_focus;
  decltype(glfwSetWindowCloseCallback)* on_close;

  /// Throws Unavailable where GLFW is not installed.
  Glfw();
  std::string last_error() const;
};

/// GLFW is initialised while at least one of these exists.
class GlfwInitialised {
 public:
  explicit GlfwInitialised(const Glfw& glfw);
  GlfwInitialised(const GlfwInitialised&) = delete;
  GlfwInitialised& operator=(const GlfwInitialised&) = delete;
  ~GlfwInitialised();

 private:
  // GLFW's own state, mirrored: glfwTerminate ends every window whatever glfwInit was called
  // before.
  static inline int alive = 0;
  const Glfw& glfw_;
};

/// A window with a context. Main thread only, as GLFW asks.
class GlfwContext : public Native {
 public:
  enum class Shown { yes, no };
  GlfwContext(Size size, const std::string& title, Shown shown);
  ~GlfwContext() override;

  void make_current() override;
  void release() override;
  Function function(const char* gl_name) const override;
  std::string name() const override { return "GLFW"; }

 protected:
  const Glfw& glfw() const { return glfw_; }
  GLFWwindow* handle() const { return window_; }

 private:
  void set_hints(int profile, Shown shown) const;

  Glfw glfw_;
  GlfwInitialised initialised_;
  GLFWwindow* window_ = nullptr;
};

}  // namespace shadowlab::context
