#include "live/damage.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace shadowlab::live {
namespace {

Rectangle between(double left, double top, double right, double bottom) {
  return {left, top, std::max(0.0, right - left), std::max(0.0, bottom - top)};
}

bool is_empty(const Rectangle& r) { return r.width <= 0 || r.height <= 0; }

Rectangle common(const Rectangle& a, const Rectangle& b) {
  return between(std::max(a.x, b.x), std::max(a.y, b.y), std::min(a.x + a.width, b.x + b.width),
                 std::min(a.y + a.height, b.y + b.height));
}

Rectangle around(const Rectangle& a, const Rectangle& b) {
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return between(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x + a.width, b.x + b.width),
                 std::max(a.y + a.height, b.y + b.height));
}

Rectangle of(const ImVec4& clip) { return between(clip.x, clip.y, clip.z, clip.w); }

// In whole pixels: `outward` all that it touches, else those that are all in it.
Rectangle whole(const Rectangle& r, bool outward) {
  const auto low = [&](double x) { return outward ? std::floor(x) : std::ceil(x); };
  const auto high = [&](double x) { return outward ? std::ceil(x) : std::floor(x); };
  return between(low(r.x), low(r.y), high(r.x + r.width), high(r.y + r.height));
}

template <class T>
void mix(std::size_t& hash, const ImVector<T>& values) {
  const std::string_view bytes(reinterpret_cast<const char*>(values.Data),
                               static_cast<std::size_t>(values.size_in_bytes()));
  hash = hash * 31 + std::hash<std::string_view>{}(bytes);
}

ImVec2 place(const ImDrawList& list, const ImDrawCmd& command, unsigned index) {
  const unsigned vertex = list.IdxBuffer[static_cast<int>(command.IdxOffset + index)];
  return list.VtxBuffer[static_cast<int>(command.VtxOffset + vertex)].pos;
}

Rectangle box_of(const ImDrawList& list, const ImDrawCmd& command) {
  if (command.ElemCount == 0) return {};
  ImVec2 low = place(list, command, 0), high = low;
  for (unsigned i = 1; i < command.ElemCount; ++i) {
    const ImVec2 at = place(list, command, i);
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  return common(between(low.x, low.y, high.x, high.y), of(command.ClipRect));
}

// The first quad of a command that is a picture's.
Rectangle quad_of(const ImDrawList& list, const ImDrawCmd& command) {
  const ImVec2 a = place(list, command, 0), b = place(list, command, 2);
  return common(between(a.x, a.y, b.x, b.y), of(command.ClipRect));
}

void add(Part& part, const ImDrawList& list, ImTextureID letters) {
  part.lists.push_back(&list);
  mix(part.contents, list.VtxBuffer);
  mix(part.contents, list.IdxBuffer);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    part.box = around(part.box, whole(box_of(list, command), true));
    const float clip[] = {command.ClipRect.x, command.ClipRect.y, command.ClipRect.z,
                          command.ClipRect.w};
    for (const float side : clip) part.contents = part.contents * 31 + std::hash<float>{}(side);
    part.contents = part.contents * 31 + std::hash<ImTextureID>{}(command.GetTexID());
    part.contents = part.contents * 31 + command.ElemCount;
    if (command.ElemCount == 0 || command.GetTexID() == letters) continue;
    part.shows_pictures = true;
    const Rectangle quad = whole(quad_of(list, command), false);
    if (quad.width * quad.height > part.covered.width * part.covered.height) part.covered = quad;
  }
}

// What of `box` is not in `hole`.
std::vector<Rectangle> outside(const Rectangle& box, const Rectangle& hole) {
  const Rectangle inner = common(box, hole);
  if (is_empty(inner)) return {box};
  const double right = box.x + box.width, bottom = box.y + box.height;
  const double inner_right = inner.x + inner.width, inner_bottom = inner.y + inner.height;
  std::vector<Rectangle> strips{between(box.x, box.y, right, inner.y),
                                between(box.x, inner_bottom, right, bottom),
                                between(box.x, inner.y, inner.x, inner_bottom),
                                between(inner_right, inner.y, right, inner_bottom)};
  std::erase_if(strips, is_empty);
  return strips;
}

}  // namespace

std::vector<Part> parts_of(const ImDrawData& frame, ImTextureID letters) {
  std::vector<Part> parts;
  for (int i = 0; i < frame.CmdListsCount; ++i) {
    const ImDrawList& list = *frame.CmdLists[i];
    // A child is named after its window: "passes/list_2243073E".
    const std::string_view owner = list._OwnerName ? list._OwnerName : "";
    const std::string_view name = owner.substr(0, owner.find('/'));
    if (parts.empty() || parts.back().name != name) parts.emplace_back().name = name;
    add(parts.back(), list, letters);
  }
  return parts;
}

std::vector<DrawnPart> drawn(const std::vector<Part>& parts) {
  std::vector<DrawnPart> drawn;
  drawn.reserve(parts.size());
  for (const Part& part : parts) drawn.push_back({std::string(part.name), part.contents, part.box});
  return drawn;
}

std::optional<std::vector<Damage>> damage(const std::vector<DrawnPart>& before,
                                          const std::vector<Part>& now, Pictures pictures) {
  if (!std::ranges::equal(before, now, {}, &DrawnPart::name, &Part::name)) return {};
  std::vector<Damage> all;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const bool changed = before[i].contents != now[i].contents ||
                         (now[i].shows_pictures && pictures == Pictures::may_have_changed);
    if (!changed) continue;
    const Rectangle box = around(before[i].box, now[i].box);
    for (std::size_t other = 0; other < now.size(); ++other) {
      const Rectangle its = around(before[other].box, now[other].box);
      if (other != i && !is_empty(common(box, its))) return {};
    }
    all.push_back({i, outside(box, now[i].covered)});
  }
  return all;
}

}  // namespace shadowlab::live
