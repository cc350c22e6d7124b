#include "live/live_window.h"

#include <chrono>

#include "live/interface.h"

namespace shadowlab::live {
namespace {

double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

class LiveWindow {
 public:
  explicit LiveWindow(const LiveOptions& options)
      : graphics_(context::create_window({"shadowlab", {1280, 800}}), options.width,
                  options.height),
        window_(*graphics_.context().window()),
        screen_(graphics_),
        interface_(graphics_),
        studio_(graphics_, options.studio) {}

  void run() {
    double last = now();
    while (open_) {
      const double began = now();
      take(window_.events(std::max(0.0, last + 1.0 / 60 - began)));
      const double present = now();
      studio_.step(present - last);
      last = present;
      draw();
    }
  }

 private:
  void take(const std::vector<context::Event>& events) {
    for (const context::Event& event : events) {
      if (std::holds_alternative<context::CloseAsked>(event)) open_ = false;
      if (const auto* key = std::get_if<context::KeyEvent>(&event);
          key && key->key == context::Key::escape)
        open_ = false;
      if (const auto* typed = std::get_if<context::Typed>(&event);
          typed && typed->character < 128) {
        const char c = static_cast<char>(typed->character);
        studio_.press({&c, 1});
      }
      interface_.take(event);
    }
  }

  void draw() {
    const context::Size size = window_.size();
    if (size.width < 1 || size.height < 1) return;
    interface_.set_style(Style::desk, window_.scale());
    interface_.begin(size, 1.0 / 60);
    ImGui::GetBackgroundDrawList()->AddImage(texture_id(studio_.bench().picture), {0, 0},
                                             {static_cast<float>(studio_.bench().picture.width()),
                                              static_cast<float>(studio_.bench().picture.height())},
                                             {0, 1}, {1, 0});
    if (const auto& failure = studio_.bench().workshop.failure())
      ImGui::TextUnformatted(failure->sentence.c_str());
    screen_.begin(size.width, size.height, {0.08f, 0.09f, 0.10f});
    interface_.end(screen_);
    window_.swap();
  }

  gl::Graphics graphics_;
  context::Window& window_;
  gl::Screen screen_;
  Interface interface_;
  Studio studio_;
  bool open_ = true;
};

}  // namespace

void show(const LiveOptions& options) { LiveWindow(options).run(); }

}  // namespace shadowlab::live
