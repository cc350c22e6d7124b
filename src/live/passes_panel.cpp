// The frame's passes, and what the chosen one did.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "live/panels.h"

namespace shadowlab::live {
namespace {

constexpr float list_height = 0.38f;  // of the panel

void hint(const char* text) {
  // At what is seen of the panel, which may scroll sideways.
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth());
  ImGui::TextDisabled("%s", text);
  ImGui::PopTextWrapPos();
}

void draw_list(Studio& studio, const View& view) {
  const auto& passes = studio.inspector().passes();
  const std::vector<double>& times = view.readings.passes_ms();
  const double longest = times.empty() ? 0 : std::ranges::max(times);
  const double all = std::accumulate(times.begin(), times.end(), 0.0);
  ImGui::Text("%zu pass%s, %.2f ms", passes.size(), passes.size() == 1 ? "" : "es", all);
  ImGui::BeginChild("list", {0, ImGui::GetWindowHeight() * list_height}, false);
  if (ImGui::Selectable("the whole frame", !studio.chosen_pass())) studio.choose_pass({});
  const float width = ImGui::GetContentRegionAvail().x, number = ImGui::CalcTextSize("000.00 ").x;
  for (std::size_t i = 0; i < passes.size() && i < times.size(); ++i) {
    const PassReport& pass = passes[i];
    ImGui::PushID(static_cast<int>(i));
    const bool chosen = studio.chosen_pass() == pass.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // A bar below the name says how much of the frame it took.
    const auto share = static_cast<float>(longest > 0 ? times[i] / longest : 0);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x, at.y + ImGui::GetTextLineHeight() + 1},
        {at.x + share * width, at.y + ImGui::GetTextLineHeight() + 1 + stroke(2)},
        ImGui::GetColorU32(ImGuiCol_CheckMark));
    ImGui::PushClipRect(at, {at.x + width - number, at.y + 3 * ImGui::GetTextLineHeight()}, true);
    if (ImGui::Selectable(pass.name.name.c_str(), chosen)) studio.choose_pass(pass.name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", pass.name.name.c_str());
    if (chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    ImGui::PopClipRect();
    ImGui::SameLine(width - number);
    ImGui::Text("%6.2f", times[i]);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void draw_buffers(Studio& studio) {
  using Buffer = LookedAt::Buffer;
  const auto button = [&](const char* name, LookedAt what) {
    if (choice(name, studio.looked_at() == what)) studio.look_at(what);
  };
  button("colour", {Buffer::color, 0});
  ImGui::SameLine();
  button("depth", {Buffer::depth, 0});
  ImGui::SameLine();
  button("stencil", {Buffer::stencil, 0});
  const auto& attachments = studio.inspector().buffers().attachments;
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    button(fmt::format("framebuffer {} {} {}x{}", attachments[i].framebuffer,
                       attachments[i].name.substr(3), attachments[i].width, attachments[i].height)
               .c_str(),
           {Buffer::attachment, i});
  }
}

// The chosen pass's place in the list.
std::optional<std::size_t> place_of(const Studio& studio) {
  const auto& passes = studio.inspector().passes();
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (studio.chosen_pass() == passes[i].name) return i;
  }
  return {};
}

void draw_state(Studio& studio) {
  const auto place = place_of(studio);
  if (!place || !studio.inspector().passes()[*place].state) {
    hint("Down chooses a pass: its GL state is here.");
    return;
  }
  const auto& passes = studio.inspector().passes();
  const GLuint frame = studio.graphics().calls().main_frame;
  const auto now = gl::as_c(*passes[*place].state, frame);
  std::vector<std::string> before;
  if (*place > 0 && passes[*place - 1].state) before = gl::as_c(*passes[*place - 1].state, frame);
  const auto differs = [&](std::size_t i) { return i < before.size() && before[i] != now[i]; };
  // What changed comes first; what did not, below.
  for (const bool changed : {true, false}) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (differs(i) != changed) continue;
      if (changed && now[i].empty()) {
        ImGui::TextColored({1, 0.8f, 0.3f, 1}, "- %s", before[i].c_str());
      } else if (changed) {
        ImGui::TextColored({1, 0.8f, 0.3f, 1}, "> %s", now[i].c_str());
      } else if (!now[i].empty() && !now[i].starts_with("glDisable")) {
        ImGui::TextDisabled("  %s", now[i].c_str());
      }
    }
  }
}

void draw_calls(Studio& studio) {
  const auto place = place_of(studio);
  if (!place) {
    hint("Down chooses a pass: its calls are here.");
    return;
  }
  const auto& calls = studio.calls();
  if (calls.empty()) ImGui::TextDisabled("no calls");
  for (const std::string& call : calls) ImGui::TextUnformatted(call.c_str());
}

std::string change(const gl::MainFrame::Pixel& before, const gl::MainFrame::Pixel& now) {
  std::string text;
  if (now.rgba != before.rgba)
    text += fmt::format(" colour {} {} {}", now.rgba[0], now.rgba[1], now.rgba[2]);
  if (now.depth != before.depth) text += fmt::format(" depth {:.6f}", now.depth);
  if (now.stencil != before.stencil) text += fmt::format(" stencil {}", now.stencil);
  return text;
}

void draw_pixel(Studio& studio) {
  if (!studio.pixel()) {
    hint("The pixel under the pointer.");
    return;
  }
  ImGui::Text("pixel %d, %d from the top left", studio.pixel()->x, studio.pixel()->y);
  std::optional<gl::MainFrame::Pixel> before;
  for (const PassReport& pass : studio.inspector().passes()) {
    if (!pass.pixel) continue;
    const std::string text =
        before ? change(*before, *pass.pixel)
               : fmt::format(" colour {} {} {} depth {:.6f} stencil {}", pass.pixel->rgba[0],
                             pass.pixel->rgba[1], pass.pixel->rgba[2], pass.pixel->depth,
                             pass.pixel->stencil);
    if (text.empty()) {
      ImGui::TextDisabled("%s", pass.name.name.c_str());
    } else {
      ImGui::TextUnformatted(pass.name.name.c_str());
      ImGui::TextColored({1, 0.8f, 0.3f, 1}, "  %s", text.c_str());
    }
    before = pass.pixel;
  }
}

}  // namespace

void draw_passes(Studio& studio, View& view, const Interface& interface) {
  draw_list(studio, view);
  ImGui::Separator();
  draw_buffers(studio);
  ImGui::Separator();
  using Details = View::Details;
  const auto tab = [&](const char* name, Details details) {
    if (choice(name, view.details == details)) view.details = details;
  };
  tab("state", Details::state);
  ImGui::SameLine();
  tab("calls", Details::calls);
  ImGui::SameLine();
  tab("pixel", Details::pixel);
  studio.set_tracing(view.details == Details::calls ? Studio::Tracing::on : Studio::Tracing::off);
  ImGui::PushFont(interface.code());
  ImGui::BeginChild("details", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
  if (const int lines = std::exchange(view.scrolls, 0)) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + static_cast<float>(lines) * line, 0.0f,
                                 ImGui::GetScrollMaxY()));
  }
  if (view.details == Details::state) draw_state(studio);
  if (view.details == Details::calls) draw_calls(studio);
  if (view.details == Details::pixel) draw_pixel(studio);
  ImGui::EndChild();
  ImGui::PopFont();
}

}  // namespace shadowlab::live
