// What a hand does in the picture: camera, light and objects of all recipes.
#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "live/studio.h"

namespace shadowlab::live {

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
    move(std::string(scene()->objects[held_.object].name), model);
  }
}

void Studio::move(const std::string& object, const glm::dmat4& model) {
  hand_moves();
  for (const auto& bench : benches_) {
    try {
      bench->workshop.move(object, model);
    } catch (const InputError&) {
      // Its scene has no such object.
    }
  }
  touch();
}

void Studio::shift_caster(std::size_t which, glm::dvec3 step) {
  if (!scene()) return;
  std::vector<const scene::Object*> casters;
  for (const scene::Object& object : scene()->objects)
    if (object.casts()) casters.push_back(&object);
  if (casters.empty()) return;
  const scene::Object& caster = *casters[which % casters.size()];
  glm::dmat4 model = caster.model;
  model[3] += glm::dvec4(step, 0);
  say(fmt::format("moves {}", caster.name));
  move(std::string(caster.name), model);
}

}  // namespace shadowlab::live
