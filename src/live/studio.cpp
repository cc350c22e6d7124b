#include "live/studio.h"

#include <chrono>
#include <utility>

#include "core/error.h"

namespace shadowlab::live {
namespace {

double now_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Studio::Studio(gl::Graphics& graphics, StudioOptions options) : graphics_(graphics) {
  for (const auto& file : options.recipes) {
    benches_.push_back(std::make_unique<Bench>(graphics, file, options.recipe));
    for (const auto& [name, value] : options.settings) benches_.back()->workshop.set(name, value);
  }
}

bool Studio::step(double seconds) {
  const double before = clock_.time();
  clock_.advance(seconds);
  const bool moved = clock_.time() != before || std::exchange(touched_, false);
  bool any = false;
  for (const auto& bench : benches_) {
    if (!bench->workshop.look() && !moved) continue;
    const double began = now_ms();
    const Moment moment{clock_.time(), camera_};
    any = true;
    if (bench->workshop.draw(moment) == Workshop::Drawn::nothing) continue;
    graphics_.gl.Finish.unrecorded();
    bench->frame_ms = now_ms() - began;
    bench->picture.copy_main_frame();
  }
  return any;
}

void Studio::reload_all() {
  for (const auto& bench : benches_) bench->workshop.reload();
}

std::optional<scene::Camera> Studio::camera() const {
  if (camera_) return camera_;
  const recipe::Recipe* recipe = benches_[focus_]->workshop.recipe();
  if (!recipe || !recipe->scene()) return {};
  return recipe->scene()->camera;
}

void Studio::set_camera(const scene::Camera& camera) {
  camera_ = camera;
  for (const auto& bench : benches_) bench->workshop.retry();
  touch();
}

// A version takes the scene's own camera along only when it is made.
void Studio::reset_camera() {
  camera_.reset();
  reload_all();
}

void Studio::set(const std::string& name, const std::string& value) {
  bench().workshop.set(name, value);
  if (name == "light") {
    for (const auto& other : benches_) {
      if (other.get() == &bench()) continue;
      try {
        other->workshop.set(name, value);
      } catch (const InputError&) {
        // Its light is of another kind.
      }
    }
  }
  touch();
}

bool Studio::press(std::string_view character) {
  const recipe::Recipe* recipe = bench().workshop.recipe();
  if (!recipe) return false;
  for (const recipe::KeyAction& action : recipe->keys()) {
    if (action.key != character) continue;
    for (const auto& known : recipe->parameters()) {
      if (known.name != action.parameter) continue;
      set(known.name, recipe::pressed(action, known.parameter));
      return true;
    }
  }
  return false;
}

}  // namespace shadowlab::live
