#include "live/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/clock.h"
#include "core/error.h"

namespace shadowlab::live {
namespace {

constexpr double rest = 0.15;     // seconds after which a hand is thought to be still
constexpr double slow = 40;       // ms: a frame that a hand feels
constexpr double crawling = 160;  // ms: one that half the size would not help enough
constexpr int warming = 2;        // frames in which shaders are compiled and buffers made

}  // namespace

Studio::Studio(gl::Graphics& graphics, const StudioOptions& options)
    : graphics_(graphics),
      options_(options.recipe),
      inspector_(graphics),
      buffer_picture_(graphics),
      truth_(graphics) {
  for (const auto& file : options.recipes) {
    auto bench = std::make_unique<Bench>(graphics, file, options.recipe);
    for (const auto& [name, value] : options.settings) bench->workshop.set(name, value);
    bench->workshop.on_version([this](recipe::Recipe& recipe) { inspector_.attach(recipe); });
    benches_.push_back(std::move(bench));
  }
}

Studio::Studio(gl::Graphics& graphics, const StudioOptions& options, const Kept& kept)
    : Studio(graphics, options) {
  for (std::size_t i = 0; i < benches_.size() && i < kept.changes.size(); ++i)
    benches_[i]->workshop.take_over(kept.changes[i]);
  set_focus(kept.focus);
  clock_ = kept.clock;
  camera_ = kept.camera;
  chosen_ = kept.pass;
  looked_at_ = kept.looked_at;
  truth_mode_ = kept.truth;
}

Studio::Kept Studio::kept() const {
  Kept kept{{}, focus_, clock_, camera_, chosen_, looked_at_, truth_mode_};
  for (const auto& bench : benches_) kept.changes.push_back(bench->workshop.changes());
  return kept;
}

void Studio::set_focus(std::size_t index) {
  focus_ = index < benches_.size() ? index : 0;
  chosen_.reset();
  truth_.forget();
  truth_stale_ = true;
  touch();
}

bool Studio::step(double seconds) {
  const double before = clock_.time();
  clock_.advance(seconds);
  if (moves_ && rested_ >= rest) {
    moves_ = false;
    if (std::exchange(coarse_, false)) touch();
  }
  const bool touched = std::exchange(touched_, false) || screenshot_wanted_;
  bool any = false, changed = touched;
  for (const auto& bench : benches_) {
    const bool wanted = bench->workshop.look();
    const recipe::Recipe* const recipe = bench->workshop.recipe();
    const bool stands_still = !recipe || !recipe->read_time() || clock_.time() == before;
    if (!wanted && !touched && bench->cold == 0 && stands_still) continue;
    changed = changed || wanted;
    any = true;
    const Moment moment{clock_.time(), camera_};
    if (wanted || !moves_ || !draw_coarse(*bench, moment)) draw(*bench, moment);
    if (!recipe) share_light(*bench);
    const int version = bench->workshop.versions();
    bench->cold =
        std::exchange(bench->version, version) != version ? warming : std::max(0, bench->cold - 1);
  }
  update_truth(seconds, changed);
  film(seconds);
  return truth_.poll() || any;
}

// Recipes of one scene begin under one light, so that what differs is what they do.
void Studio::share_light(Bench& bench) {
  const recipe::Recipe* const first = benches_[0]->workshop.recipe();
  const recipe::Recipe* const recipe = bench.workshop.recipe();
  if (&bench == benches_[0].get() || !first || !recipe ||
      first->description().scene != recipe->description().scene ||
      bench.workshop.changes().settings.contains("light"))
    return;
  try {
    const glm::dvec4 light = first->light();
    if (light == recipe->light() || light.w != recipe->light().w) return;
    bench.workshop.set("light", fmt::format("{},{},{}", light.x, light.y, light.z));
    touch();
  } catch (const InputError&) {
    // One of the two has no light.
  }
}

void Studio::hand_moves() {
  moves_ = true;
  rested_ = 0;
}

bool Studio::draw_coarse(Bench& bench, const Moment& moment) {
  // A pass or a pixel that is looked at is looked at as it is.
  if (detail_ == Detail::full || bench.frame_ms < slow || chosen_ || film_ || screenshot_wanted_ ||
      looked_at_.buffer != LookedAt::Buffer::color)
    return false;
  const int width = graphics_.width(), height = graphics_.height();
  const int coarseness = bench.frame_ms < crawling ? 2 : 4;
  const bool drawn = bench.workshop.draw_coarse(moment, coarseness) == Workshop::Drawn::picture;
  if (drawn) bench.picture.copy_main_frame();
  graphics_.resize(width, height);
  coarse_ = coarse_ || drawn;
  return drawn;
}

void Studio::draw(Bench& bench, const Moment& moment) {
  const bool focused = &bench == &this->bench();
  const bool buffers =
      chosen_ || looked_at_.buffer != LookedAt::Buffer::color || numbers_ == Numbers::shown;
  if (focused)
    inspector_.begin({chosen_, buffers ? std::optional(looked_at_) : std::nullopt, pixel_});
  const bool traced = focused && tracing_ == Tracing::on;
  if (traced) {
    recorder_.clear();
    graphics_.trace_into(&recorder_);
  }
  const bool tries = bench.workshop.tries_next();
  const int version = bench.workshop.versions();
  const double began = now_ms();
  const auto drawn = bench.workshop.draw(moment);
  graphics_.trace_into(nullptr);
  if (drawn == Workshop::Drawn::nothing) {
    if (focused) inspector_.stop();
    return;
  }
  graphics_.gl.Finish.unrecorded();
  // A version that failed took time, too, and is not what is shown.
  if (!tries || bench.workshop.versions() != version) bench.frame_ms = now_ms() - began;
  if (focused) inspector_.finish(*bench.workshop.recipe());
  if (focused && std::exchange(screenshot_wanted_, false)) save_screenshot();
  if (focused && film_) film_picture_ = graphics_.frame.read_color();
  bench.picture.copy_main_frame();
  if (focused) show_buffers();
  if (focused && inspector_.missed_state()) touch();
  if (traced) keep_calls();
}

void Studio::reload_all() {
  for (const auto& bench : benches_) bench->workshop.reload();
}

const scene::Scene* Studio::scene() const {
  const recipe::Recipe* recipe = bench().workshop.recipe();
  return recipe ? recipe->scene() : nullptr;
}

void Studio::set(const std::string& name, const std::string& value) {
  hand_moves();
  bench().workshop.set(name, value);
  for (const auto& other : benches_) {
    if (name != "light" || other.get() == &bench()) continue;
    try {
      other->workshop.set(name, value);
    } catch (const InputError&) {
      // It has no light, or one of another kind.
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

void Studio::set_truth_mode(TruthMode mode) {
  truth_mode_ = mode;
  truth_stale_ = true;
  if (mode == TruthMode::off) truth_.forget();
}

// Traced when the hand is still: a comparison is of one camera and one light.
void Studio::update_truth(double seconds, bool changed) {
  if (changed) truth_stale_ = true;
  rested_ = changed ? 0 : rested_ + seconds;
  const recipe::Recipe* recipe = bench().workshop.recipe();
  if (truth_mode_ == TruthMode::off || !truth_stale_ || rested_ < rest || !recipe ||
      truth_.busy() || bench().workshop.failure())
    return;
  truth_stale_ = false;
  truth_.begin(bench().workshop.file(), options_, *recipe, clock_.time());
}

}  // namespace shadowlab::live
