// The numbers of pixels that are enlarged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "live/panels.h"

namespace shadowlab::live {
namespace {

// What is in a pixel, in as many lines as are of interest.
std::vector<std::string> numbers_of(const Studio& studio, std::size_t index) {
  using Buffer = LookedAt::Buffer;
  const Buffers& buffers = studio.inspector().buffers();
  switch (studio.looked_at().buffer) {
    case Buffer::depth:
      if (index < buffers.depth.values.size())
        return {fmt::format("{:.5f}", buffers.depth.values[index])};
      break;
    case Buffer::stencil:
      if (index < buffers.stencil.size()) return {fmt::format("{}", buffers.stencil[index])};
      break;
    case Buffer::attachment: {
      if (studio.looked_at().attachment >= buffers.attachments.size()) break;
      const auto& contents = buffers.attachments[studio.looked_at().attachment];
      std::vector<std::string> lines;
      const auto channels = static_cast<std::size_t>(contents.channels);
      for (std::size_t c = 0; c < channels && index * channels + c < contents.values.size(); ++c)
        lines.push_back(fmt::format("{:.4g}", contents.values[index * channels + c]));
      return lines;
    }
    case Buffer::color:
      if (4 * index + 2 >= buffers.color.rgba.size()) break;
      return {fmt::format("{}", buffers.color.rgba[4 * index]),
              fmt::format("{}", buffers.color.rgba[4 * index + 1]),
              fmt::format("{}", buffers.color.rgba[4 * index + 2])};
  }
  return {};
}

}  // namespace

bool shows_numbers(const PictureView& picture) {
  return picture.zoom() >= 3.2 * static_cast<double>(ImGui::GetTextLineHeight());
}

void draw_numbers(const Studio& studio, const View& view, int width, int height) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const PictureView& picture = view.picture;
  const double line = ImGui::GetTextLineHeight();
  const auto clamped = [](double value, int most) {
    return std::clamp(static_cast<int>(std::floor(value)), 0, most);
  };
  const Rectangle& area = picture.area();
  const glm::dvec2 low =
      glm::dvec2(area.x - picture.placed().x, area.y - picture.placed().y) / picture.zoom();
  const glm::dvec2 high = low + glm::dvec2(area.width, area.height) / picture.zoom();
  for (int y = clamped(low.y, height - 1); y <= clamped(high.y, height - 1); ++y) {
    for (int x = clamped(low.x, width - 1); x <= clamped(high.x, width - 1); ++x) {
      const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x);
      glm::dvec2 at = picture.corner_of(x, y) + glm::dvec2(4, 3);
      const ImU32 color = studio.is_light_at(index) ? IM_COL32_BLACK : IM_COL32_WHITE;
      for (const std::string& text : numbers_of(studio, index)) {
        list.AddText(ImVec2(static_cast<float>(at.x), static_cast<float>(at.y)), color,
                     text.c_str());
        at.y += line;
      }
    }
  }
}

}  // namespace shadowlab::live
