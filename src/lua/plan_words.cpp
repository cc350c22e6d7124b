#include "lua/plan_words.h"

#include <fmt/format.h>

#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

struct Savings {
  std::size_t triangles = 0, bytes = 0;
  void add(std::size_t indices) {
    triangles += indices / 3;
    bytes += indices * sizeof(std::uint32_t);
  }
};

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string of_so_many(const Savings& savings) {
  return fmt::format("{} of volumes, {} of their indices",
                     counted(savings.triangles, "triangle", "triangles"),
                     counted(savings.bytes, "byte", "bytes"));
}

shadow::VolumeIndices volume_of(Stage& stage, const scene::Object& object, glm::dvec4 light) {
  return stage.volumes->source(object.mesh)
      ->builder.build(glm::dvec4(glm::vec4(shadow::light_in_model_space(object.model, light))), {});
}

// "house 3, house 4 and 5 others"
std::string names_of(const scene::Scene& scene, const std::vector<std::size_t>& objects) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < objects.size() && i < most; ++i)
    text += (i ? ", " : "") + scene.objects[objects[i]].name;
  if (objects.size() > most)
    text += fmt::format(" and {}", counted(objects.size() - most, "other", "others"));
  return text;
}

void explain_dropped(Stage& stage, const scene::Scene& scene, glm::dvec4 light,
                     const shadow::Plan& plan, shadow::Plan::Why why, const char* reason) {
  std::vector<std::size_t> objects;
  Savings savings;
  for (const auto& dropped : plan.dropped) {
    if (dropped.why != why) continue;
    objects.push_back(dropped.object);
    savings.add(volume_of(stage, scene.objects[dropped.object], light).all.size());
  }
  if (objects.empty()) return;
  stage.explain(fmt::format("Dropped: {} ({}), {}. Saved: {}.",
                            counted(objects.size(), "caster", "casters"), names_of(scene, objects),
                            reason, of_so_many(savings)));
}

}  // namespace

void explain_casters(Stage& stage, const scene::Scene& scene, glm::dvec4 light,
                     const shadow::Plan& plan) {
  const std::size_t all = plan.casters.size() + plan.dropped.size();
  stage.explain(
      fmt::format("The plan keeps {} of {}: those whose box or shadow meets the box of "
                  "something that the camera sees.",
                  plan.casters.size(), counted(all, "caster", "casters")));
  explain_dropped(stage, scene, light, plan, shadow::Plan::Why::outside_view,
                  "since neither they nor their shadows are in the camera's view");
  explain_dropped(stage, scene, light, plan, shadow::Plan::Why::meets_nothing,
                  "since in the view they and their shadows are hidden, or meet nothing");
}

void explain_plan(Stage& stage, const scene::Scene& scene, glm::dvec4 light,
                  const shadow::Plan& plan) {
  explain_casters(stage, scene, light, plan);
  std::vector<std::size_t> zpass, zfail;
  Savings caps;
  std::int64_t pixels = 0;
  for (const auto& kept : plan.casters) {
    pixels += kept.scissor.area();
    (kept.apart ? zpass : zfail).push_back(kept.object);
    if (!kept.apart) continue;
    const auto volume = volume_of(stage, scene.objects[kept.object], light);
    caps.add(volume.all.size() - volume.sides.size());
  }
  if (!zpass.empty()) {
    stage.explain(fmt::format(
        "Z-pass without caps: {} ({}), since a plane parts their boxes from the pyramid from the "
        "near rectangle to the light. Saved: {}.",
        counted(zpass.size(), "caster", "casters"), names_of(scene, zpass), of_so_many(caps)));
  }
  if (!zfail.empty()) {
    stage.explain(fmt::format(
        "Z-fail with caps: {} ({}), since their boxes meet that pyramid, so that the near plane "
        "may be in their shadow.",
        counted(zfail.size(), "caster", "casters"), names_of(scene, zfail)));
  }
  const glm::ivec2 size = stage.picture_size();
  const std::int64_t picture = std::int64_t{size.x} * size.y;
  const auto kept = static_cast<std::int64_t>(plan.casters.size());
  stage.explain(fmt::format(
      "Scissors leave the kept volumes {} pixels of {} ({} times {} × {}): outside of them they "
      "meet nothing that is seen. Saved: {} pixels at most.",
      pixels, kept * picture, kept, size.x, size.y, kept * picture - pixels));
  stage.explain(
      fmt::format("{} of {} are in the view, not hidden by boxes, and drawn; shadows may reach {} "
                  "of those, within {} × {} pixels.",
                  plan.seen.size(), counted(scene.objects.size(), "object", "objects"),
                  plan.shadowed.size(), plan.shadows.width, plan.shadows.height));
}

}  // namespace shadowlab::lua
