#include "live/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "live/commands.h"

namespace shadowlab::live {
namespace {

// In heights of a letter.
constexpr double left_width = 16, right_width = 23, least_width = 8, status_height = 2.1;
// Of the window: however large the type, the picture has the most of it.
constexpr double most_left = 0.22, most_right = 0.32;

struct Places {
  Rectangle left, middle, right, status;
};

Places places(const View& view) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const double letter = ImGui::GetFontSize(), width = size.x, height = size.y;
  Places places;
  const double status = std::min(height, status_height * letter);
  const bool room = width * (1 - most_left - most_right) > least_width * letter;
  const bool shown = view.panels && room;
  const double left = shown ? std::min(left_width * letter, most_left * width) : 0;
  const double right = shown ? std::min(right_width * letter, most_right * width) : 0;
  places.left = {0, 0, left, height - status};
  places.right = {width - right, 0, right, height - status};
  places.middle = {left, 0, width - left - right, height - status};
  places.status = {0, height - status, width, status};
  return places;
}

void draw_status(Studio& studio, const View& view, const Rectangle& area) {
  if (!begin_place("status", area, Scrolling::no)) return ImGui::End();
  std::string text = fmt::format("{:.1f} ms", view.readings.frame_ms());
  const Clock& clock = studio.clock();
  const recipe::Recipe* const recipe = studio.bench().workshop.recipe();
  // Who does not ask for the time has none.
  if (recipe && recipe->read_time()) text += fmt::format("    t = {:.2f} s", clock.time());
  if (clock.paused()) text += "    paused";
  if (clock.speed() != 1) text += "    slow motion";
  if (studio.filming()) text += "    filming";
  if (view.overlay != Overlay::none) text += fmt::format("    {}", name_of(view.overlay));
  if (studio.truth_mode() != TruthMode::off)
    text += fmt::format("    {}: {}", name_of(studio.truth_mode()), studio.truth().sentence());
  if (!studio.message().empty()) text += "    " + studio.message();
  ImGui::TextUnformatted(text.c_str());
  const char* const hint = "F1 keys";
  ImGui::SameLine(static_cast<float>(area.width) - ImGui::CalcTextSize(hint).x -
                  ImGui::GetStyle().WindowPadding.x);
  ImGui::TextDisabled("%s", hint);
  ImGui::End();
}

// Several pictures share the middle: as few rows as keep them from becoming strips.
std::vector<Rectangle> shares(const Rectangle& area, std::size_t count) {
  const auto columns = static_cast<std::size_t>(std::max(
      1.0,
      std::ceil(std::sqrt(static_cast<double>(count) * area.width / std::max(1.0, area.height)) -
                0.25)));
  const std::size_t rows = (count + columns - 1) / columns;
  std::vector<Rectangle> shares;
  for (std::size_t i = 0; i < count; ++i) {
    const double width = area.width / static_cast<double>(std::min(columns, count));
    const double height = area.height / static_cast<double>(rows);
    const std::size_t column = i % columns, row = i / columns;
    shares.push_back({area.x + static_cast<double>(column) * width,
                      area.y + static_cast<double>(row) * height, width, height});
  }
  return shares;
}

// What it is, and what is wrong with it, in its corner.
void draw_label(const Bench& bench, ImVec2 corner) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::string& title = bench.workshop.recipe() ? bench.workshop.recipe()->description().title
                                                     : bench.workshop.file().string();
  const ImVec2 margin = ImGui::GetStyle().FramePadding;
  const auto line = [&](ImU32 color, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 end{corner.x + size.x + 2 * margin.x, corner.y + size.y + 2 * margin.y};
    list.AddRectFilled(corner, end, IM_COL32(0, 0, 0, 160));  // legible over any picture
    list.AddText({corner.x + margin.x, corner.y + margin.y}, color, text.c_str());
    corner.y = end.y;
  };
  line(IM_COL32(255, 255, 255, 255), title);
  if (bench.workshop.failure())
    line(IM_COL32(255, 130, 120, 255), bench.workshop.failure()->sentence);
}

// A bench that is not in focus. Whether it was clicked.
bool draw_other(const Studio& studio, std::size_t index, const Rectangle& area) {
  const Bench& bench = *studio.benches()[index];
  PictureView view;
  view.place(area, std::max(1, bench.picture.width()), std::max(1, bench.picture.height()));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Rectangle& at = view.placed();
  const ImVec2 low{static_cast<float>(at.x), static_cast<float>(at.y)};
  const ImVec2 high{static_cast<float>(at.x + at.width), static_cast<float>(at.y + at.height)};
  list.PushClipRect(low, high, true);
  if (bench.picture.texture()) list.AddImage(texture_id(bench.picture), low, high, {0, 1}, {1, 0});
  list.PopClipRect();
  const ImGuiIO& io = ImGui::GetIO();
  return !io.WantCaptureMouse && io.MouseClicked[0] && area.holds(io.MousePos.x, io.MousePos.y);
}

// Of each of several recipes its name, clipped to its place.
void draw_labels(const Studio& studio, const std::vector<Rectangle>& areas) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (std::size_t i = 0; i < areas.size() && areas.size() > 1; ++i) {
    const Rectangle& at = areas[i];
    const ImVec2 low{static_cast<float>(at.x) + 2, static_cast<float>(at.y) + 2};
    list.PushClipRect(
        low, {static_cast<float>(at.x + at.width) - 2, static_cast<float>(at.y + at.height) - 2});
    draw_label(*studio.benches()[i], low);
    list.PopClipRect();
  }
}

void draw_border(const Rectangle& area) {
  ImGui::GetBackgroundDrawList()->AddRect(
      {static_cast<float>(area.x + 1), static_cast<float>(area.y + 1)},
      {static_cast<float>(area.x + area.width - 1), static_cast<float>(area.y + area.height - 1)},
      ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 0, stroke(2));
}

}  // namespace

bool begin_place(const char* name, const Rectangle& area, Scrolling scrolls) {
  const ImGuiWindowFlags scrolling =
      scrolls == Scrolling::no ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse
                               : ImGuiWindowFlags_None;
  ImGui::SetNextWindowPos({static_cast<float>(area.x), static_cast<float>(area.y)});
  ImGui::SetNextWindowSize({static_cast<float>(std::max(1.0, area.width)),
                            static_cast<float>(std::max(1.0, area.height))});
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                          scrolling);
}

float stroke(float pixels) { return std::round(pixels * ImGui::GetFontSize() / 16 + 0.4f); }

bool choice(const char* name, bool chosen) {
  if (chosen)
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_HeaderActive]);
  const bool clicked = ImGui::Button(name);
  if (chosen) ImGui::PopStyleColor();
  return clicked;
}

void draw_window(Studio& studio, View& view, const Interface& interface) {
  view.readings.add(studio.bench().frame_ms, studio.inspector().passes(),
                    static_cast<double>(ImGui::GetIO().DeltaTime));
  const Places places = live::places(view);
  const auto areas = shares(places.middle, studio.benches().size());
  std::optional<std::size_t> clicked;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (i != studio.focus() && draw_other(studio, i, areas[i])) clicked = i;
  }
  // In halves of one size while the truth is beside the picture, also until it is traced.
  const bool beside = studio.truth_mode() == TruthMode::beside;
  const auto halves = shares(areas[studio.focus()], beside ? 2 : 1);
  draw_picture(studio, view, interface, halves[0]);
  if (beside) draw_truth_beside(studio, view, halves[1]);
  draw_labels(studio, areas);
  draw_light(studio, view);
  if (areas.size() > 1) draw_border(areas[studio.focus()]);
  if (places.left.width > 0) {
    for (const double x : {places.middle.x, places.middle.x + places.middle.width}) {
      ImGui::GetBackgroundDrawList()->AddLine(
          {static_cast<float>(x), 0},
          {static_cast<float>(x), static_cast<float>(places.middle.height)},
          ImGui::GetColorU32(ImGuiCol_Separator));
    }
    if (begin_place("parameters", places.left)) draw_parameters(studio, view);
    ImGui::End();
    if (begin_place("passes", places.right)) draw_passes(studio, view, interface);
    ImGui::End();
  }
  draw_status(studio, view, places.status);
  if (const auto& failure = studio.bench().workshop.failure())
    draw_failure(*failure, interface, areas[studio.focus()]);
  if (view.help) draw_help(studio, view, interface);
  if (clicked) studio.set_focus(*clicked);
}

void draw_failure(const Failure& failure, const Interface& interface, const Rectangle& area) {
  const double margin = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(
      {static_cast<float>(area.x + margin), static_cast<float>(area.y + area.height - margin)},
      ImGuiCond_Always, {0, 1});
  const auto width = static_cast<float>(std::max(1.0, area.width - 2 * margin));
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, static_cast<float>(area.height)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(40, 12, 12, 245));
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 245, 240, 255));
  ImGui::Begin("error", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  std::string where = fmt::format("While {}", name_of(failure.stage));
  if (!failure.pass.empty()) where += fmt::format(", in pass \"{}\"", failure.pass);
  if (failure.line > 0) {
    where += fmt::format(": {}, line {}", std::filesystem::path(failure.file).filename().string(),
                         failure.line);
  }
  ImGui::TextColored({1, 0.55f, 0.5f, 1}, "%s", where.c_str());
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(failure.sentence.c_str());
  ImGui::PopTextWrapPos();
  if (!failure.around.empty()) {
    ImGui::Separator();
    ImGui::PushFont(interface.code());
    for (const SourceLine& line : failure.around) {
      const std::string text = fmt::format("{:>5}  {}", line.number, line.text);
      if (line.number == failure.line) {
        ImGui::TextColored({1, 0.8f, 0.3f, 1}, "%s", text.c_str());
      } else {
        ImGui::TextDisabled("%s", text.c_str());
      }
    }
    ImGui::PopFont();
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

void draw_help(Studio& studio, View& view, const Interface& interface) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {size.x, size.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyle().Colors[ImGuiCol_PopupBg]);
  ImGui::PushFont(interface.small());
  ImGui::Begin(
      "Keys", &view.help,
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove);
  using Row = std::pair<std::string, std::string>;
  std::vector<Row> ours, theirs;
  for (const Command& command : commands())
    if (command.keys) ours.emplace_back(command.keys, command.does);
  ours.emplace_back("mouse", "drag the light, a caster, or the view; the wheel goes nearer");
  if (const recipe::Recipe* recipe = studio.bench().workshop.recipe()) {
    for (const recipe::KeyAction& action : recipe->keys())
      theirs.emplace_back(action.key, action.words);
  }
  // Side by side: one below the other is higher than a window.
  if (ImGui::BeginTable("keys", theirs.empty() ? 2 : 4)) {
    for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
      ImGui::TableNextRow();
      for (const auto* rows : {&ours, &theirs}) {
        if (rows->empty()) continue;
        const Row row = i < rows->size() ? (*rows)[i] : Row();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.first.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.second.c_str());
      }
    }
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopFont();
  ImGui::PopStyleColor();
}

}  // namespace shadowlab::live
