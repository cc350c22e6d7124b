// A window's contents without the window: recipes, panels, a pointer.
#pragma once

#include "core/version.h"
#include "live/commands.h"
#include "live/panels.h"
#include "workshop_fixture.h"

namespace shadowlab::live {

class WindowTest : public WorkshopTest {
 protected:
  static constexpr int width = 640, height = 400;

  WindowTest()
      : small(context::create(context::Backend::osmesa, {width, height}), 48, 48),
        interface(small),
        screen(small) {}

  void open(std::vector<fs::path> recipes) {
    studio.emplace(small, StudioOptions{std::move(recipes), {}, {}});
  }
  static fs::path stock(const std::string& name) { return home() / "scripts" / (name + ".lua"); }

  /// The recipes' frame, and what the panels say of it.
  void say() {
    pictures = studio->step(0) ? Pictures::may_have_changed : Pictures::as_they_were;
    interface.begin({width, height}, 1.0 / 60);
    draw_window(*studio, view, interface);
  }
  void show(gl::Screen& on) {
    on.begin(width, height, ground_of(view.style));
    interface.end(on, pictures);
  }
  void frame() {
    say();
    show(screen);
  }

  void press(context::Key key, context::Modifiers modifiers = {}) {
    run_command({key, 0, context::Press::down, modifiers}, *studio, view);
  }
  void point(double x, double y) {
    interface.take(context::PointerAt{x, y});
    frame();
  }
  void button(context::Press press) {
    interface.take(context::ButtonEvent{context::Button::left, press, {}});
    frame();
    frame();
  }

  gl::Graphics small;
  Interface interface;
  gl::Screen screen;
  std::optional<Studio> studio;
  View view;
  Pictures pictures = Pictures::may_have_changed;
};

}  // namespace shadowlab::live
