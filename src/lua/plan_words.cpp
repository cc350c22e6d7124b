#include "lua/plan_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

struct Savings {
  std::size_t triangles = 0, bytes = 0;
  std::int64_t pixels = 0;
  void add(std::size_t indices) {
    triangles += indices / 3;
    bytes += indices * sizeof(std::uint32_t);
  }
};

// Casters that were held against one light, or one of several.
struct Held {
  const scene::Scene& scene;
  glm::dvec4 light;
  const shadow::Plan& plan;
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

void explain_dropped(Stage& stage, std::span<const Held> lights, shadow::Plan::Why why,
                     const char* reason) {
  std::vector<std::size_t> objects;
  std::size_t count = 0;
  Savings savings;
  for (const Held& held : lights) {
    for (const auto& dropped : held.plan.dropped) {
      if (dropped.why != why) continue;
      ++count;
      if (std::ranges::find(objects, dropped.object) == objects.end())
        objects.push_back(dropped.object);
      savings.add(volume_of(stage, held.scene.objects[dropped.object], held.light).all.size());
      savings.pixels += dropped.covered.area();
    }
  }
  if (objects.empty()) return;
  const std::string times =
      lights.size() == 1 ? "" : fmt::format(", {} in all", counted(count, "volume", "volumes"));
  stage.explain(fmt::format("Dropped: {} ({}){}, {}. Saved: {}, which would cover {} at most.",
                            counted(objects.size(), "caster", "casters"),
                            names_of(lights[0].scene, objects), times, reason, of_so_many(savings),
                            counted(static_cast<std::size_t>(savings.pixels), "pixel", "pixels")));
}

void explain_casters(Stage& stage, std::span<const Held> lights) {
  std::size_t kept = 0, all = 0;
  for (const Held& held : lights) {
    kept += held.plan.casters.size();
    all += held.plan.casters.size() + held.plan.dropped.size();
  }
  const std::string what =
      lights.size() == 1
          ? counted(all, "caster", "casters")
          : fmt::format("{} for {} lights", counted(all, "volume", "volumes"), lights.size());
  stage.explain(
      fmt::format("The plan keeps {} of {}: those whose box or shadow meets the box of "
                  "something that the camera sees.",
                  kept, what));
  explain_dropped(stage, lights, shadow::Plan::Why::outside_view,
                  "since neither they nor their shadows are in the camera's view");
  explain_dropped(stage, lights, shadow::Plan::Why::meets_nothing,
                  "since in the view they and their shadows are hidden, or meet nothing");
  explain_dropped(stage, lights, shadow::Plan::Why::all_lit,
                  "since they are seen from lit sides alone and shadow nothing else that is seen");
}

// The plan of volumes, with those that are drawn all the same among the kept ones.
shadow::Plan as_left_out(const Planned::Volumes& volumes) {
  shadow::Plan plan = volumes.plan;
  const auto drawn = [&](const auto& dropped) { return !volumes.drops(dropped.object); };
  for (const auto& dropped : plan.dropped) {
    if (drawn(dropped)) plan.casters.push_back({dropped.object, {}, {}, false});
  }
  std::erase_if(plan.dropped, drawn);
  return plan;
}

// "256 × 256 texels"
std::string texels_of(const Planned::Map& map) { return fmt::format("{0} × {0} texels", map.size); }

void explain_map(Stage& stage, const Planned::Map& map, std::size_t number, std::size_t of) {
  if (!map.needs) {
    stage.explain(fmt::format("Map {} of {} is {}.", number, of,
                              map.asked == 0
                                  ? "drawn by nothing that the plan knows of"
                                  : "drawn as it is: shadow.map_bias was not told how it is read"));
    return;
  }
  const std::string which = fmt::format("Map {} of {}, {}", number, of, texels_of(map));
  if (map.skipped && map.asked == 0) {
    std::size_t triangles = 0;
    for (const scene::Object& object : map.scene->objects)
      triangles += object.casts() ? object.mesh->indices.size() / 3 : 0;
    const std::size_t texels =
        static_cast<std::size_t>(map.size) * static_cast<std::size_t>(map.size);
    stage.explain(
        fmt::format("{}, is neither allocated nor drawn, since no caster shadows what is seen "
                    "where it would be "
                    "read. Saved: {}, {} that are cleared, at least {}.",
                    which, counted(triangles, "triangle", "triangles"),
                    counted(texels, "pixel", "pixels"), counted(3 * texels, "byte", "bytes")));
    return;
  }
  if (map.dropped == 0) {
    stage.explain(
        fmt::format("{}: all {} are drawn, since lookups at what is seen may meet each. Nothing is "
                    "saved.",
                    which, counted(map.asked, "caster", "casters")));
    return;
  }
  stage.explain(fmt::format(
      "{}: {} of {} drawn; the others are outside of it, or no lookup at what is seen can meet "
      "them. Saved: {} in {}, which would cover {} at most, and no bytes.{}",
      which, map.asked - map.dropped, counted(map.asked, "caster", "casters"),
      counted(map.triangles_saved, "triangle", "triangles"), counted(map.dropped, "draw", "draws"),
      counted(static_cast<std::size_t>(map.pixels_saved), "pixel", "pixels"),
      map.needs->read() ? "" : " Nobody reads it: it is cleared alone."));
}

}  // namespace

void explain_plan(Stage& stage, const scene::Scene& scene, glm::dvec4 light,
                  const shadow::Plan& plan) {
  const Held held{scene, light, plan};
  explain_casters(stage, {&held, 1});
  std::vector<std::size_t> zpass, zfail, without;
  Savings caps, volumes;
  std::int64_t pixels = 0;
  for (const auto& kept : plan.casters) {
    pixels += kept.scissor.area();
    if (kept.scissor.area() == 0) {
      without.push_back(kept.object);
      volumes.add(volume_of(stage, scene.objects[kept.object], light).all.size());
      continue;
    }
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
  if (!without.empty()) {
    stage.explain(fmt::format(
        "No volume: {} ({}), since they shadow nothing that is seen but their own sides turned "
        "from the light, which are known without. Saved: {}.",
        counted(without.size(), "caster", "casters"), names_of(scene, without),
        of_so_many(volumes)));
  }
  const glm::ivec2 size = stage.picture_size();
  const std::int64_t picture = std::int64_t{size.x} * size.y;
  const auto kept = static_cast<std::int64_t>(zpass.size() + zfail.size());
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

void explain_planned(Stage& stage) {
  std::deque<shadow::Plan> plans;
  std::vector<Held> lights;
  for (const Planned::Volumes& volumes : stage.planned->volumes()) {
    plans.push_back(as_left_out(volumes));
    lights.push_back({*volumes.scene, volumes.light, plans.back()});
  }
  if (!lights.empty()) explain_casters(stage, lights);
  const auto& maps = stage.planned->maps();
  std::size_t number = 0;
  for (const Planned::Map& map : maps) explain_map(stage, map, ++number, maps.size());
  if (lights.empty() && maps.empty()) {
    stage.explain(
        "The plan leaves nothing out: the recipe draws neither volumes of the scene's objects nor "
        "maps that are fitted to the view.");
  }
}

}  // namespace shadowlab::lua
