#include "live/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/clock.h"
#include "core/error.h"

namespace shadowlab::live {
namespace {

constexpr double rest = 0.15;  // seconds after which a hand is thought to be still
constexpr double slow = 40;    // ms: a frame that a hand feels
constexpr int coarseness = 2;

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
  const bool moved = clock_.time() != before || touched;
  bool any = false, changed = touched;
  for (const auto& bench : benches_) {
    const bool wanted = bench->workshop.look();
    if (!wanted && !moved) continue;
    changed = changed || wanted;
    any = true;
    const Moment moment{clock_.time(), camera_};
    if (wanted || !moves_ || !draw_coarse(*bench, moment)) draw(*bench, moment);
  }
  update_truth(seconds, changed);
  if (film_) film_time_ -= seconds;
  return truth_.poll() || any;
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
  const bool drawn = bench.workshop.draw_coarse(moment, coarseness) == Workshop::Drawn::picture;
  if (drawn) bench.picture.copy_main_frame();
  graphics_.resize(width, height);
  coarse_ = coarse_ || drawn;
  return drawn;
}

void Studio::draw(Bench& bench, const Moment& moment) {
  const bool focused = &bench == &this->bench();
  const bool buffers = chosen_ || looked_at_.buffer != LookedAt::Buffer::color;
  if (focused) inspector_.begin({chosen_, buffers, pixel_});
  const bool traced = focused && tracing_ == Tracing::on;
  if (traced) {
    recorder_.clear();
    graphics_.trace_into(&recorder_);
  }
  const double began = now_ms();
  const auto drawn = bench.workshop.draw(moment);
  graphics_.trace_into(nullptr);
  if (drawn == Workshop::Drawn::nothing) {
    if (focused) inspector_.stop();
    return;
  }
  graphics_.gl.Finish.unrecorded();
  bench.frame_ms = now_ms() - began;
  if (focused) inspector_.finish(*bench.workshop.recipe());
  if (focused && std::exchange(screenshot_wanted_, false)) save_screenshot();
  if (focused && film_ && film_time_ <= 0) {
    film_time_ += 1.0 / Film::frames_per_second;
    if (!film_->add(graphics_.frame.read_color())) toggle_film("");
  }
  bench.picture.copy_main_frame();
  if (focused) show_buffers();
  if (traced) keep_calls();
}

// As `run` writes it: opaque, whatever the frame's alpha is.
void Studio::save_screenshot() {
  try {
    image::Image picture = graphics_.frame.read_color();
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    const auto file = unused_file(bench().workshop.file().stem().string(), ".png");
    image::write_png(file, picture);
    say(fmt::format("the picture is in {}", file.string()));
  } catch (const std::exception& problem) {
    say(problem.what());
  }
}

void Studio::reload_all() {
  for (const auto& bench : benches_) bench->workshop.reload();
}

const scene::Scene* Studio::scene() const {
  const recipe::Recipe* recipe = bench().workshop.recipe();
  return recipe ? recipe->scene() : nullptr;
}

double Studio::aspect() const {
  return static_cast<double>(graphics_.width()) / graphics_.height();
}

std::optional<scene::Camera> Studio::camera() const {
  if (camera_) return camera_;
  if (!scene()) return {};
  return scene()->camera;
}

void Studio::set_camera(const scene::Camera& camera) {
  camera_ = camera;
  hand_moves();
  for (const auto& bench : benches_) bench->workshop.retry();
  touch();
}

std::optional<glm::dvec4> Studio::light() const {
  const recipe::Recipe* recipe = bench().workshop.recipe();
  if (!recipe) return {};
  try {
    return recipe->light();
  } catch (const InputError&) {
    return {};
  }
}

void Studio::set_light(glm::dvec4 light) {
  try {
    set("light", fmt::format("{},{},{}", light.x, light.y, light.z));
  } catch (const InputError&) {
    // The recipe has no light to move.
  }
}

// A version takes the scene's own camera along only when it is made.
void Studio::reset() {
  camera_.reset();
  for (const auto& bench : benches_) bench->workshop.reset_parameters();
  touch();
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

Studio::Grip Studio::grip_at(glm::dvec2 place, double reach) const {
  const auto camera = this->camera();
  if (!camera) return Grip::nothing;
  if (const auto light = this->light()) {
    const Seen handle = seen(*camera, aspect(), light_handle(*light, *camera));
    const glm::dvec2 off = (glm::dvec2(handle.x, handle.y) - place) * glm::dvec2(aspect(), 1);
    if (handle.distance > 0 && glm::length(off) < reach) return Grip::light;
  }
  if (scene() && first_caster(*scene(), ray_through(*camera, aspect(), place.x, place.y)))
    return Grip::object;
  return Grip::camera;
}

Studio::Grip Studio::grab(glm::dvec2 place, Grip wanted) {
  held_ = {};
  const auto camera = this->camera();
  if (!camera) return Grip::nothing;
  held_.grip = wanted;
  held_.place = place;
  if (wanted == Grip::light && light()) held_.point = light_handle(*light(), *camera);
  if (wanted == Grip::object) {
    const auto hit = first_caster(*scene(), ray_through(*camera, aspect(), place.x, place.y));
    if (!hit) return held_.grip = Grip::camera;
    held_.object = hit->object;
    held_.point = hit->point;
    held_.model = scene()->objects[hit->object].model;
  }
  return held_.grip;
}

// A light moves in the plane that faces the camera, an object along the floor.
void Studio::drag(glm::dvec2 place) {
  const auto camera = this->camera();
  if (!camera || held_.grip == Grip::nothing) return;
  const glm::dvec2 step = place - std::exchange(held_.place, place);
  const Ray ray = ray_through(*camera, aspect(), place.x, place.y);
  if (held_.grip == Grip::camera) {
    set_camera(orbited(*camera, step.x * 90 * aspect(), -step.y * 90));
  } else if (held_.grip == Grip::light && light()) {
    const glm::dvec3 forward = glm::normalize(camera->target - camera->eye);
    if (const auto to = on_plane(ray, held_.point, forward))
      set_light(light_of_handle(*to, *light(), *camera));
  } else if (held_.grip == Grip::object && scene() && held_.object < scene()->objects.size()) {
    const auto to = on_plane(ray, held_.point, glm::normalize(camera->up));
    if (!to) return;
    glm::dmat4 model = held_.model;
    model[3] += glm::dvec4(*to - held_.point, 0);
    hand_moves();
    const std::string name = scene()->objects[held_.object].name;
    for (const auto& bench : benches_) {
      try {
        bench->workshop.move(name, model);
      } catch (const InputError&) {
        // Its scene has no such object.
      }
    }
    touch();
  }
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

void Studio::toggle_film(const std::string& ending) {
  try {
    if (film_) {
      Film film = std::move(*film_);
      film_.reset();
      film.finish();
      say(fmt::format("{} frames are in {}", film.frames(), film.file().string()));
      return;
    }
    film_.emplace(unused_file(bench().workshop.file().stem().string(), ending), graphics_.width(),
                  graphics_.height());
    film_time_ = 0;
    say("filming; the same key ends it");
  } catch (const std::exception& problem) {
    film_.reset();
    say(problem.what());
  }
}

}  // namespace shadowlab::live
