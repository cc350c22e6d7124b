#include "lab/diagnose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowlab::lab {
namespace {

Judgement judged(const PixelMask& differs, const ReferenceCase& reference) {
  const image::Image& picture = reference.drawing().frame.color;
  return judge(differs, picture.width, picture.height,
               [&]() -> const PixelMask& { return reference.regions().edge; });
}

const Buffers* pass_of(const Drawing& drawing, const std::string& name) {
  const int at = find_pass(drawing.passes, name);
  return at < 0 ? nullptr : &drawing.passes[static_cast<std::size_t>(at)];
}

bool same_picture(const Case& a_case, const ReferenceCase& edges, const Drawing& a,
                  const Drawing& b) {
  if (a.error || b.error) return false;
  if (a_case.compared.color && !judged(differing(a.frame.color, b.frame.color), edges).fits())
    return false;
  if (const auto& name = a_case.compared.stencil) {
    const Buffers *one = pass_of(a, *name), *other = pass_of(b, *name);
    if (!one || !other || !judged(differing(one->stencil, other->stencil), edges).fits())
      return false;
  }
  if (const auto& name = a_case.compared.depth) {
    const Buffers *one = pass_of(a, *name), *other = pass_of(b, *name);
    if (!one || !other || !judged(differing(one->depth, other->depth), edges).fits()) return false;
  }
  return true;
}

struct Departure {
  std::string buffer;
  PixelMask pixels;
};

// The stencil before the colour: it is what a pass is for where both depart.
std::optional<Departure> departure(const ReferenceCase& reference, const Buffers& mine,
                                   const Buffers& theirs) {
  for (Departure found : {Departure{"stencil", differing(theirs.stencil, mine.stencil)},
                          Departure{"color", differing(theirs.color, mine.color)},
                          Departure{"depth", differing(theirs.depth, mine.depth)}}) {
    if (!judged(found.pixels, reference).fits()) return found;
  }
  return std::nullopt;
}

std::string region_of(const PixelMask& pixels, const ReferenceCase& reference) {
  if (!reference.has_truth()) return "";
  const Regions& regions = reference.regions();
  if (regions.edge.size() != pixels.size()) return "";
  std::array<std::size_t, 4> counts{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!pixels[i]) continue;
    ++counts[regions.edge[i] ? 0 : regions.ground[i] ? 1 : regions.shadow[i] ? 2 : 3];
  }
  constexpr std::array names{"edge", "ground", "shadow", "lit"};
  const auto most = std::max_element(counts.begin(), counts.end()) - counts.begin();
  return names[static_cast<std::size_t>(most)];
}

// In which third of the picture the middle half of the pixels lies; 9: they are spread.
int place_of(const PixelMask& pixels, int width, int height) {
  std::vector<int> xs, ys;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!pixels[i]) continue;
    xs.push_back(static_cast<int>(i % static_cast<std::size_t>(width)));
    ys.push_back(static_cast<int>(i / static_cast<std::size_t>(width)));
  }
  if (xs.empty()) return 9;
  const auto third = [](std::vector<int>& all, int size) {
    std::sort(all.begin(), all.end());
    const int spread = all[all.size() * 3 / 4] - all[all.size() / 4];
    return std::pair{std::min(2, all[all.size() / 2] * 3 / size), 2 * spread > size};
  };
  const auto [column, wide] = third(xs, width);
  const auto [row, high] = third(ys, height);
  return wide && high ? 9 : 3 * row + column;
}

Say say_region(const std::string& region) {
  if (region == "edge") return Say::at_edges;
  if (region == "ground") return Say::beyond_surfaces;
  return region == "shadow" ? Say::in_shadow : Say::in_light;
}
Say say_buffer(const std::string& buffer) {
  if (buffer == "stencil") return Say::stencil;
  return buffer == "depth" ? Say::depth : Say::color;
}
Say say_place(int place) { return static_cast<Say>(static_cast<int>(Say::top_left) + place); }

struct NamedState {
  std::string_view key;
  Say name;
};
constexpr std::array named_states = std::to_array<NamedState>({
    {"glEnable(GL_DEPTH_TEST)", Say::depth_test},
    {"glEnable(GL_STENCIL_TEST)", Say::stencil_test},
    {"glEnable(GL_BLEND)", Say::blending},
    {"glEnable(GL_CULL_FACE)", Say::culling},
    {"glEnable(GL_POLYGON_OFFSET_FILL)", Say::offset_switch},
    {"glDepthFunc", Say::depth_function},
    {"glDepthMask", Say::depth_writing},
    {"glColorMask", Say::color_mask},
    {"glStencilFunc", Say::stencil_function},
    {"glStencilOp", Say::stencil_operation},
    {"glStencilMask", Say::stencil_mask},
    {"glCullFace", Say::culled_face},
    {"glFrontFace", Say::winding},
    {"glBlendFunc", Say::blend_function},
    {"glBlendEquation", Say::blend_equation},
    {"glPolygonOffset", Say::polygon_offset},
    {"glViewport", Say::viewport},
    {"glScissor", Say::scissor_box},
});

std::string name_of_state(Language language, const std::string& key) {
  for (const NamedState& state : named_states) {
    if (state.key == key) return std::string(text(language, state.name));
  }
  if (key.starts_with("uniform "))
    return std::string(text(language, Say::the_uniform)) + " " + key.substr(8);
  return say(language, Say::the_call, key);
}

std::string value_of_state(Language language, const std::optional<Setting>& setting) {
  if (!setting) return std::string(text(language, Say::unset));
  if (setting->values == std::vector<std::string>{"on"})
    return std::string(text(language, Say::switched_on));
  if (setting->values == std::vector<std::string>{"off"})
    return std::string(text(language, Say::switched_off));
  return in_words(*setting);
}

void locate(Diagnosis& diagnosis, const Departure& found, const ReferenceCase& reference,
            Language language) {
  const image::Image& picture = reference.drawing().frame.color;
  Finding& finding = diagnosis.finding;
  finding.buffer = found.buffer;
  finding.pixels =
      static_cast<std::size_t>(std::count(found.pixels.begin(), found.pixels.end(), 1));
  finding.region = region_of(found.pixels, reference);
  const int place = place_of(found.pixels, picture.width, picture.height);
  finding.place = text(Language::english, say_place(place));
  const auto where = finding.region.empty() ? Say::everywhere : say_region(finding.region);
  if (finding.pass_number > 0) {
    diagnosis.says.push_back(say(language, Say::first_departure, finding.pass,
                                 text(language, say_buffer(found.buffer)), finding.pixels,
                                 text(language, where), text(language, say_place(place))));
  } else {
    diagnosis.says.push_back(say(language, Say::after_the_passes, finding.pixels,
                                 text(language, where), text(language, say_place(place))));
  }
}

}  // namespace

CaseVerdict verdict_of(const Case& a_case, const ReferenceCase& reference, const Drawing& drawing) {
  const Drawing& theirs = reference.drawing();
  CaseVerdict verdict;
  if (a_case.compared.color) {
    verdict.compared = "color";
    verdict.judgement = judged(differing(theirs.frame.color, drawing.frame.color), reference);
    if (!verdict.right()) return verdict;
  }
  const auto compare = [&](const char* buffer, const std::optional<std::string>& name,
                           auto member) {
    if (!name || !verdict.right()) return;
    verdict.compared = buffer;
    verdict.pass = *name;
    const Buffers* mine = pass_of(drawing, *name);
    verdict.pass_missing = !mine;
    if (mine) {
      verdict.judgement =
          judged(differing(pass_of(theirs, *name)->*member, mine->*member), reference);
    }
  };
  compare("stencil", a_case.compared.stencil, &Buffers::stencil);
  compare("depth", a_case.compared.depth, &Buffers::depth);
  return verdict;
}

std::optional<std::size_t> matching_mistake(const Lab& lab, const Reference& reference,
                                            const std::vector<Drawing>& drawings) {
  // A case that shows no difference says nothing about the mistake.
  std::vector<std::size_t> wrong;
  for (std::size_t c = 0; c < drawings.size(); ++c) {
    const ReferenceCase& right = reference.cases[c];
    if (!same_picture(lab.cases[c], right, right.drawing(), drawings[c])) wrong.push_back(c);
  }
  std::optional<std::size_t> best;
  std::size_t most = 0;
  for (std::size_t m = 0; m < reference.mistakes.size(); ++m) {
    const auto alike =
        static_cast<std::size_t>(std::count_if(wrong.begin(), wrong.end(), [&](std::size_t c) {
          return same_picture(lab.cases[c], reference.cases[c], reference.mistakes[m][c],
                              drawings[c]);
        }));
    if (alike > most) {
      most = alike;
      best = m;
    }
  }
  return best;
}

std::string say_state(const StateDifference& state, const std::string& pass, Language language) {
  return say(language, Say::state_differs, pass, name_of_state(language, state.key),
             value_of_state(language, state.yours), value_of_state(language, state.theirs));
}

Diagnosis diagnose(const ReferenceCase& reference, const Drawing& drawing, Language language) {
  const Drawing& theirs = reference.drawing();
  Diagnosis diagnosis;
  for (std::size_t i = 0; i < theirs.passes.size(); ++i) {
    const std::string& name = theirs.passes[i].pass;
    int mine = find_pass(drawing.passes, name);
    // Renamed passes are taken in their order.
    if (mine < 0 && drawing.passes.size() == theirs.passes.size()) mine = static_cast<int>(i);
    if (mine < 0) {
      diagnosis.says.push_back(say(language, Say::pass_missing, name));
      break;
    }
    const auto& pass = drawing.passes[static_cast<std::size_t>(mine)];
    if (const auto found = departure(reference, pass, theirs.passes[i])) {
      diagnosis.yours = mine;
      diagnosis.theirs = static_cast<int>(i);
      diagnosis.finding.pass = pass.pass;
      diagnosis.finding.pass_number = mine + 1;
      locate(diagnosis, *found, reference, language);
      diagnosis.states = differences(works_of(drawing.calls), diagnosis.yours,
                                     works_of(theirs.calls), diagnosis.theirs);
      return diagnosis;
    }
  }
  if (const auto found = departure(reference, drawing.frame, theirs.frame))
    locate(diagnosis, *found, reference, language);
  return diagnosis;
}

}  // namespace shadowlab::lab
