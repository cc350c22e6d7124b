#include "live/live_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/clock.h"
#include "core/error.h"
#include "live/commands.h"
#include "live/panels.h"

namespace shadowlab::live {
namespace {

constexpr double frame = 1000.0 / 60;  // ms
constexpr double patience = 1;         // seconds after which a frame is long

// All that is of one context.
struct Opened {
  Opened(const LiveOptions& options, const StudioOptions& studio_options, const Studio::Kept& kept)
      : graphics(context::create_window({"shadowlab", {1280, 800}}), options.width, options.height),
        window(*graphics.context().window()),
        screen(graphics),
        interface(graphics),
        studio(graphics, studio_options, kept) {}

  gl::Graphics graphics;
  context::Window& window;
  gl::Screen screen;
  Interface interface;
  Studio studio;
};

class LiveWindow {
 public:
  explicit LiveWindow(const LiveOptions& options) : options_(options) {
    options_.studio.recipe.stop = [this] { return is_to_stop(); };
    view_.panels = options.panels == LiveOptions::Panels::shown;
    open({});
  }

  void run() {
    double last = now_ms();
    while (view_.open) {
      if (opened_->window.lost() || std::exchange(view_.renewed, false))
        open(opened_->studio.kept());
      hear(std::max(0.0, last + frame - now_ms()) / 1000);
      take(std::exchange(heard_, {}));
      stops_ = false;
      const double present = now_ms(), seconds = (present - last) / 1000;
      drawing_since_ = present;
      // A script that took seconds is no leap of the clock.
      const bool fresh = opened_->studio.step(std::min(seconds, 0.25));
      draw(seconds, fresh ? Pictures::may_have_changed : Pictures::as_they_were);
      last = present;
    }
  }

 private:
  void open(const Studio::Kept& kept) {
    opened_.reset();  // a context that is lost takes what is still asked of it, and does nothing
    title_.clear();
    opened_.emplace(options_, options_.studio, kept);
  }

  void hear(double seconds) {
    for (const context::Event& event : opened_->window.events(seconds)) heard_.push_back(event);
  }

  // While a script runs the window goes on listening, so that no script holds it: what is asked of
  // it waits for the frame's end, but to close it, and to stop or reload a recipe that takes long.
  bool is_to_stop() {
    const std::size_t before = heard_.size();
    hear(0);
    const double seconds = (now_ms() - drawing_since_) / 1000;
    const bool long_enough = seconds > patience;
    for (std::size_t i = before; i < heard_.size(); ++i) {
      const auto* const key = std::get_if<context::KeyEvent>(&heard_[i]);
      const bool pressed = key && key->press == context::Press::down;
      const bool quits = pressed && key->character == 'q' && key->modifiers.control;
      if (quits || std::holds_alternative<context::CloseAsked>(heard_[i])) view_.open = false;
      if (!pressed || !long_enough) continue;
      if (key->key == context::Key::f5) stops_ = true;
      if (key->key == context::Key::escape) {
        stops_ = true;
        heard_.erase(heard_.begin() + static_cast<std::ptrdiff_t>(i));  // no wish to quit
        break;
      }
    }
    if (long_enough)
      set_title(fmt::format("drawing for {:.0f} s, Esc stops it - shadowlab", seconds));
    return stops_ || !view_.open;
  }

  void take(const std::vector<context::Event>& events) {
    for (const context::Event& event : events) {
      opened_->interface.take(event);
      if (std::holds_alternative<context::CloseAsked>(event)) view_.open = false;
      if (opened_->interface.types()) continue;
      try {
        if (const auto* key = std::get_if<context::KeyEvent>(&event))
          run_command(*key, opened_->studio, view_);
        if (const auto* typed = std::get_if<context::Typed>(&event)) type(typed->character);
      } catch (const InputError& problem) {
        opened_->studio.say(problem.what());
      }
    }
  }

  void type(char32_t character) {
    if (character >= 128 || character == U' ') return;
    const char c = static_cast<char>(character);
    if (!opened_->studio.press({&c, 1}) && c == '?') view_.help = !view_.help;
  }

  void draw(double seconds, Pictures pictures) {
    set_title(title());
    opened_->window.set_extent(view_.extent);
    const context::Size size = opened_->window.size();
    if (size.width < 1 || size.height < 1) return;
    opened_->interface.set_style(view_.style, opened_->window.scale());
    opened_->interface.begin(size, seconds);
    draw_window(opened_->studio, view_, opened_->interface);
    opened_->screen.begin(size.width, size.height, ground_of(view_.style));
    opened_->interface.end(opened_->screen, pictures);
    if (std::exchange(view_.window_shot, false)) save_window();
    opened_->window.swap();
  }

  void save_window() {
    try {
      image::Image picture = opened_->screen.read();
      for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
      const auto file = unused_file("window", ".png");
      image::write_png(file, picture);
      opened_->studio.say(fmt::format("the window is in {}", file.string()));
    } catch (const std::exception& problem) {
      opened_->studio.say(problem.what());
    }
  }

  // What a desktop's list of windows, and a test, can read.
  std::string title() const {
    const Bench& bench = opened_->studio.bench();
    std::string title = bench.workshop.file().filename().string();
    if (bench.workshop.failure()) title += " - error";
    if (const auto& pass = opened_->studio.chosen_pass()) title += " - " + pass->name;
    return title + " - shadowlab";
  }

  void set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    opened_->window.set_title(title);
  }

  LiveOptions options_;
  View view_;
  std::string title_;
  std::vector<context::Event> heard_;
  double drawing_since_ = 0;  ///< ms
  bool stops_ = false;        ///< the recipes of this step
  std::optional<Opened> opened_;
};

}  // namespace

void show(const LiveOptions& options) { LiveWindow(options).run(); }

}  // namespace shadowlab::live
