// The recipe's parameters, as what changes them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "live/panels.h"

namespace shadowlab::live {
namespace {

using Kind = lua::Parameter::Kind;

// The widget of one parameter; the new value once it is changed.
std::optional<std::string> edited(const lua::Parameter& parameter) {
  lua::Parameter after = parameter;
  auto& value = after.value;
  std::array<float, 3> numbers{};
  std::copy_n(value.begin(), std::min<std::size_t>(value.size(), 3), numbers.begin());
  bool changed = false;
  const auto least = static_cast<float>(parameter.least), most = static_cast<float>(parameter.most);
  switch (parameter.kind) {
    case Kind::number:
      changed = ImGui::SliderFloat("##value", numbers.data(), least, most, "%.3g",
                                   ImGuiSliderFlags_AlwaysClamp);
      break;
    case Kind::integer: {
      int whole = static_cast<int>(value[0]);
      changed = ImGui::SliderInt("##value", &whole, static_cast<int>(least), static_cast<int>(most),
                                 "%d", ImGuiSliderFlags_AlwaysClamp);
      numbers[0] = static_cast<float>(whole);
      break;
    }
    case Kind::toggle: {
      bool on = value[0] != 0;
      changed = ImGui::Checkbox("##value", &on);
      numbers[0] = on ? 1 : 0;
      break;
    }
    case Kind::choice: {
      auto chosen = static_cast<std::size_t>(value[0]);
      if (ImGui::BeginCombo("##value", parameter.choices[chosen].c_str())) {
        for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
          if (ImGui::Selectable(parameter.choices[i].c_str(), i == chosen)) {
            chosen = i;
            changed = true;
          }
        }
        ImGui::EndCombo();
      }
      numbers[0] = static_cast<float>(chosen);
      break;
    }
    case Kind::color:
      changed = ImGui::ColorEdit3("##value", numbers.data(), ImGuiColorEditFlags_Float);
      break;
    case Kind::point:
    case Kind::direction:
      changed = ImGui::DragFloat3("##value", numbers.data(), 0.02f, 0, 0, "%.2f");
      break;
  }
  if (!changed) return {};
  for (std::size_t i = 0; i < value.size() && i < 3; ++i) {
    // What was not touched keeps its double.
    if (static_cast<float>(value[i]) != numbers[i]) value[i] = static_cast<double>(numbers[i]);
  }
  if (parameter.kind == Kind::number || parameter.kind == Kind::integer)
    value[0] = std::clamp(value[0], parameter.least, parameter.most);
  return lua::text_of(after);
}

void draw_one(Studio& studio, View& view, std::size_t index,
              const recipe::NamedParameter& parameter) {
  ImGui::PushID(static_cast<int>(index));
  if (parameter.parameter.kind == Kind::toggle) ImGui::AlignTextToFramePadding();
  if (index == view.parameter) {
    ImGui::TextColored(ImGui::GetStyle().Colors[ImGuiCol_CheckMark], "%s", parameter.name.c_str());
  } else {
    ImGui::TextUnformatted(parameter.name.c_str());
  }
  if (parameter.parameter.kind == Kind::toggle) ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (const auto value = edited(parameter.parameter)) {
    view.parameter = index;
    try {
      studio.set(std::string(parameter.name), *value);
    } catch (const InputError& problem) {
      studio.say(problem.what());
    }
  }
  ImGui::PopID();
}

}  // namespace

void draw_parameters(Studio& studio, View& view) {
  const recipe::Recipe* recipe = studio.bench().workshop.recipe();
  if (!recipe) {
    ImGui::TextWrapped("%s", studio.bench().workshop.file().filename().string().c_str());
    return;
  }
  const recipe::Description& description = recipe->description();
  ImGui::TextWrapped("%s", description.title.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
  ImGui::TextWrapped("%s", studio.bench().workshop.file().filename().string().c_str());
  if (!description.scene.empty()) ImGui::TextWrapped("scene %s", description.scene.c_str());
  ImGui::PopStyleColor();
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  for (std::size_t i = 0; i < recipe->parameters().size(); ++i)
    draw_one(studio, view, i, recipe->parameters()[i]);
  ImGui::Spacing();
  if (ImGui::Button("Reset")) studio.reset();
  ImGui::SameLine();
  if (ImGui::Button("Reload")) studio.reload_all();
}

}  // namespace shadowlab::live
