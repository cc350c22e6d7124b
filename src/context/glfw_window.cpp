// The window that is looked at: GLFW's events as values.
#include <array>
#include <cctype>
#include <utility>

#include "context/glfw.h"
#include "context/window.h"

namespace shadowlab::context {
namespace {

struct KeyName {
  int glfw;
  Key key;
};
constexpr std::array key_names{KeyName{GLFW_KEY_ESCAPE, Key::escape},
                               KeyName{GLFW_KEY_ENTER, Key::enter},
                               KeyName{GLFW_KEY_KP_ENTER, Key::enter},
                               KeyName{GLFW_KEY_TAB, Key::tab},
                               KeyName{GLFW_KEY_BACKSPACE, Key::backspace},
                               KeyName{GLFW_KEY_INSERT, Key::insert},
                               KeyName{GLFW_KEY_DELETE, Key::erase},
                               KeyName{GLFW_KEY_LEFT, Key::left},
                               KeyName{GLFW_KEY_RIGHT, Key::right},
                               KeyName{GLFW_KEY_UP, Key::up},
                               KeyName{GLFW_KEY_DOWN, Key::down},
                               KeyName{GLFW_KEY_PAGE_UP, Key::page_up},
                               KeyName{GLFW_KEY_PAGE_DOWN, Key::page_down},
                               KeyName{GLFW_KEY_HOME, Key::home},
                               KeyName{GLFW_KEY_END, Key::end}};

Key key_of(int glfw) {
  if (glfw >= GLFW_KEY_F1 && glfw <= GLFW_KEY_F12)
    return static_cast<Key>(static_cast<int>(Key::f1) + glfw - GLFW_KEY_F1);
  for (const KeyName& name : key_names) {
    if (name.glfw == glfw) return name.key;
  }
  return Key::unknown;
}

Press press_of(int action) {
  return action == GLFW_RELEASE ? Press::up : action == GLFW_PRESS ? Press::down : Press::repeated;
}

Modifiers modifiers_of(int bits) {
  return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_ALT) != 0};
}

class GlfwWindow final : public GlfwContext, public Window {
 public:
  explicit GlfwWindow(const WindowOptions& options)
      : GlfwContext(options.size, options.title, Shown::yes) {
    glfw().set_user_pointer(handle(), this);
    listen();
  }

  Window* window() override { return this; }

  void make_current() override {
    GlfwContext::make_current();
    glfw().swap_interval(1);  // of the current context, by GLFW's rule
    if (!reset_status_) find_reset_status();
  }

  bool lost() const override {
    constexpr unsigned no_error = 0;  // GL_NO_ERROR
    return reset_status_ && reset_status_() != no_error;
  }

  std::vector<Event> events(double seconds) override {
    if (seconds > 0 && events_.empty()) {
      glfw().wait_events(seconds);
    } else {
      glfw().poll_events();
    }
    return std::exchange(events_, {});
  }

  Size size() const override {
    Size size{0, 0};
    if (glfw().window_attribute(handle(), GLFW_ICONIFIED) == GLFW_TRUE) return size;
    glfw().framebuffer_size(handle(), &size.width, &size.height);
    return size;
  }

  double scale() const override {
    float x = 1, y = 1;
    glfw().content_scale(handle(), &x, &y);
    return x > 0 ? x : 1;
  }

  void swap() override { glfw().swap_buffers(handle()); }

  void set_title(const std::string& title) override { glfw().set_title(handle(), title.c_str()); }

  Extent extent() const override {
    return glfw().window_monitor(handle()) ? Extent::full_screen : Extent::windowed;
  }

  void set_extent(Extent wanted) override {
    if (wanted == extent()) return;
    if (wanted == Extent::windowed) {
      glfw().set_monitor(handle(), nullptr, x_, y_, windowed_.width, windowed_.height, 0);
      return;
    }
    GLFWmonitor* const monitor = monitor_here();
    const GLFWvidmode* const mode = monitor ? glfw().video_mode(monitor) : nullptr;
    if (!mode) return;  // the screens are gone: the window stays as it is
    glfw().window_position(handle(), &x_, &y_);
    glfw().window_size(handle(), &windowed_.width, &windowed_.height);
    glfw().set_monitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

 private:
  static GlfwWindow& of(GLFWwindow* window);
  void listen();
  void key(int key, int scancode, int action, int bits);

  // GLX gives a stub for functions that the driver lacks: only the extensions tell.
  void find_reset_status() {
    for (const char* const suffix : {"ARB", "KHR"}) {
      const std::string words = suffix;
      if (!glfw().extension_supported(("GL_" + words + "_robustness").c_str())) continue;
      reset_status_ =
          reinterpret_cast<ResetStatus>(function(("glGetGraphicsResetStatus" + words).c_str()));
      if (reset_status_) return;
    }
  }

  // For the wheel, whose events do not say.
  Modifiers modifiers() const {
    const auto held = [this](int left, int right) {
      return glfw().key_state(handle(), left) == GLFW_PRESS ||
             glfw().key_state(handle(), right) == GLFW_PRESS;
    };
    return {held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
            held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
            held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
  }

  // The desktop's unit, which the pointer is told in, in pixels.
  double unit() const {
    int width = 0, height = 0;
    glfw().window_size(handle(), &width, &height);
    return width > 0 ? static_cast<double>(size().width) / width : 1;
  }

  // The one that the window's middle is on; the first where it is on none.
  GLFWmonitor* monitor_here() const {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfw().window_position(handle(), &x, &y);
    glfw().window_size(handle(), &width, &height);
    GLFWmonitor** const all = glfw().monitors(&count);
    for (int i = 0; i < count; ++i) {
      int left = 0, top = 0;
      glfw().monitor_position(all[i], &left, &top);
      const GLFWvidmode* const mode = glfw().video_mode(all[i]);
      if (!mode) continue;
      const int across = x + width / 2 - left, down = y + height / 2 - top;
      if (across >= 0 && down >= 0 && across < mode->width && down < mode->height) return all[i];
    }
    return count > 0 ? all[0] : nullptr;
  }

  // GLFW's callbacks are given a window alone, and whose it is only a function of GLFW tells.
  static inline decltype(glfwGetWindowUserPointer)* user_pointer = nullptr;

  using ResetStatus = unsigned (*)();
  ResetStatus reset_status_ = nullptr;  ///< null where contexts do not tell
  std::vector<Event> events_;
  int x_ = 0, y_ = 0;
  Size windowed_;
};

GlfwWindow& GlfwWindow::of(GLFWwindow* window) {
  return *static_cast<GlfwWindow*>(user_pointer(window));
}

void GlfwWindow::key(int key, int scancode, int action, int bits) {
  KeyEvent event{key_of(key), 0, press_of(action), modifiers_of(bits)};
  if (event.key == Key::unknown) {
    const char* const name = key == GLFW_KEY_SPACE ? " " : glfw().key_name(key, scancode);
    if (name && name[0] != 0 && name[1] == 0) {
      event.key = Key::character;
      event.character = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    }
  }
  events_.emplace_back(event);
}

void GlfwWindow::listen() {
  user_pointer = glfw().user_pointer;
  glfw().on_key(handle(), [](GLFWwindow* w, int key, int scancode, int action, int bits) {
    of(w).key(key, scancode, action, bits);
  });
  glfw().on_character(handle(), [](GLFWwindow* w, unsigned character) {
    of(w).events_.emplace_back(Typed{static_cast<char32_t>(character)});
  });
  glfw().on_pointer(handle(), [](GLFWwindow* w, double x, double y) {
    const double unit = of(w).unit();
    of(w).events_.emplace_back(PointerAt{x * unit, y * unit});
  });
  glfw().on_enter(handle(), [](GLFWwindow* w, int entered) {
    if (!entered) of(w).events_.emplace_back(PointerLeft{});
  });
  glfw().on_button(handle(), [](GLFWwindow* w, int button, int action, int bits) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    of(w).events_.emplace_back(
        ButtonEvent{static_cast<Button>(button), press_of(action), modifiers_of(bits)});
  });
  glfw().on_scroll(handle(), [](GLFWwindow* w, double x, double y) {
    of(w).events_.emplace_back(Scrolled{x, y, of(w).modifiers()});
  });
  glfw().on_focus(handle(), [](GLFWwindow* w, int focused) {
    if (!focused) of(w).events_.emplace_back(FocusLost{});
  });
  glfw().on_close(handle(), [](GLFWwindow* w) { of(w).events_.emplace_back(CloseAsked{}); });
}

}  // namespace

std::unique_ptr<Native> make_glfw_window(const WindowOptions& options) {
  return std::make_unique<GlfwWindow>(options);
}

}  // namespace shadowlab::context
