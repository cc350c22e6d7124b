#include "recipe/planned_casters.h"

#include "lua/plan_words.h"

namespace shadowlab::recipe {

PlannedCasters::PlannedCasters(lua::Stage& stage, scene::Scene& scene, glm::dvec4 light)
    : scene_(scene) {
  const auto plan = shadow::plan(scene, scene.camera, light, stage.picture_size());
  if (stage.explaining) lua::explain_casters(stage, scene, light, plan);
  for (const scene::Object& object : scene.objects) roles_.push_back(object.role);
  for (const auto& dropped : plan.dropped)
    scene.objects[dropped.object].role = scene::Role::receiver;
}

PlannedCasters::~PlannedCasters() {
  for (std::size_t i = 0; i < roles_.size(); ++i) scene_.objects[i].role = roles_[i];
}

}  // namespace shadowlab::recipe
