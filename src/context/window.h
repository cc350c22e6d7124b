// A window on the desktop, and what its user does in it, as plain values.
//
//   context::Context c = context::create_window({.title = "shadowlab", .size = {1280, 800}});
//   while (open) {
//     for (const context::Event& event : c.window()->events(1.0 / 60)) …
//     … draw to the context's own framebuffer 0 …
//     c.window()->swap();
//   }
//
// Lengths and places are in pixels of that framebuffer, from its top left corner, whatever the
// desktop's own units are.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "context/context.h"

namespace shadowlab::context {

/// Keys that are no character.
enum class Key {
  character,  ///< see KeyEvent::character
  unknown,
  escape,
  enter,
  tab,
  backspace,
  insert,
  erase,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  f1,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
  count
};

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

enum class Press { down, repeated, up };

struct KeyEvent {
  Key key;
  char character = 0;  ///< of Key::character: what is on it in the user's layout, in lower case
  Press press;
  Modifiers modifiers;
};
/// A character that was typed, by whichever keys the user's layout has it on.
struct Typed {
  char32_t character;
};
struct PointerAt {
  double x, y;
};
struct PointerLeft {};
enum class Button { left, right, middle };
struct ButtonEvent {
  Button button;
  Press press;
  Modifiers modifiers;
};
struct Scrolled {
  double x, y;  ///< notches
  Modifiers modifiers;
};
struct FocusLost {};
struct CloseAsked {};
using Event = std::variant<KeyEvent, Typed, PointerAt, PointerLeft, ButtonEvent, Scrolled,
                           FocusLost, CloseAsked>;

enum class Extent { windowed, full_screen };

/// Belongs to its Context and ends with it. Main thread only.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// What happened since the last call, in its order; waits for something to happen, at most so
  /// many seconds.
  virtual std::vector<Event> events(double seconds) = 0;
  /// Pixels of the context's framebuffer 0; 0 by 0 where the window is an icon.
  virtual Size size() const = 0;
  /// Pixels for one of the size that interfaces are designed for: 2 on a screen of double density.
  virtual double scale() const = 0;
  /// Shows what was drawn.
  virtual void swap() = 0;
  virtual void set_title(const std::string& title) = 0;
  virtual Extent extent() const = 0;
  virtual void set_extent(Extent extent) = 0;
  /// Whether the driver has taken the context away, as after a reset of the GPU: nothing that was
  /// made in it is left, and another window has to take this one's place.
  virtual bool lost() const = 0;
};

struct WindowOptions {
  std::string title;
  Size size{1280, 800};  ///< of a screen of single density
};

/// Opens a window, with a context that is current. Throws MachineError where there is no display.
Context create_window(const WindowOptions& options);

}  // namespace shadowlab::context
