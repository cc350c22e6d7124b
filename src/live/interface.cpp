#include "live/interface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/error.h"

namespace shadowlab::live {
namespace {

using context::Key;

static_assert(sizeof(ImDrawVert) == sizeof(gl::ScreenVertex) &&
              sizeof(ImDrawIdx) == sizeof(std::uint16_t));

constexpr double text_height = 16, projector_height = 26;
constexpr const char* fonts = "/usr/share/fonts/truetype/dejavu/";

// Characters are keys by their code, the others above them.
int index_of(Key key) { return 128 + static_cast<int>(key); }

void map_keys(ImGuiIO& io) {
  const auto map = [&io](ImGuiKey_ theirs, Key ours) { io.KeyMap[theirs] = index_of(ours); };
  map(ImGuiKey_Tab, Key::tab);
  map(ImGuiKey_LeftArrow, Key::left);
  map(ImGuiKey_RightArrow, Key::right);
  map(ImGuiKey_UpArrow, Key::up);
  map(ImGuiKey_DownArrow, Key::down);
  map(ImGuiKey_PageUp, Key::page_up);
  map(ImGuiKey_PageDown, Key::page_down);
  map(ImGuiKey_Home, Key::home);
  map(ImGuiKey_End, Key::end);
  map(ImGuiKey_Insert, Key::insert);
  map(ImGuiKey_Delete, Key::erase);
  map(ImGuiKey_Backspace, Key::backspace);
  map(ImGuiKey_Enter, Key::enter);
  map(ImGuiKey_Escape, Key::escape);
  io.KeyMap[ImGuiKey_Space] = ' ';
  io.KeyMap[ImGuiKey_A] = 'a';
  io.KeyMap[ImGuiKey_C] = 'c';
  io.KeyMap[ImGuiKey_V] = 'v';
  io.KeyMap[ImGuiKey_X] = 'x';
  io.KeyMap[ImGuiKey_Y] = 'y';
  io.KeyMap[ImGuiKey_Z] = 'z';
}

ImFont* font(const char* file, double height) {
  static constexpr ImWchar ranges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2027, 0x2190,
                                       0x21FF, 0x2200, 0x22FF, 0x2580, 0x25FF, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const std::string path = std::string(fonts) + file;
  ImFontConfig config;
  // A letter's pixels are the screen's: drawn without a filter, and sharp.
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  std::error_code none;
  if (std::filesystem::is_regular_file(path, none)) {
    if (ImFont* found =
            atlas.AddFontFromFileTTF(path.c_str(), static_cast<float>(height), &config, ranges))
      return found;
  }
  config.SizePixels = static_cast<float>(std::round(height / 13) * 13);  // it is made of dots
  return atlas.AddFontDefault(&config);
}

void hold(bool* held, int index, bool down, std::vector<int>& went_down, std::vector<int>& go_up) {
  if (down) {
    held[index] = true;
    went_down.push_back(index);
  } else if (std::ranges::find(went_down, index) != went_down.end()) {
    go_up.push_back(index);
  } else {
    held[index] = false;
  }
}

void let_go(bool* held, std::vector<int>& went_down, std::vector<int>& go_up) {
  for (const int index : go_up) held[index] = false;
  went_down.clear();
  go_up.clear();
}

ImVec4 color(unsigned rgb, float alpha = 1) {
  return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
          static_cast<float>(rgb & 255) / 255, alpha};
}

unsigned ground_rgb(Style style) { return style == Style::projector ? 0x000000 : 0x1B1D21; }

void set_colors(Style style) {
  ImGui::StyleColorsDark();
  auto& colors = ImGui::GetStyle().Colors;
  const bool projector = style == Style::projector;
  const unsigned ground = ground_rgb(style), raised = projector ? 0x2A2A2A : 0x2B2F36,
                 high = projector ? 0x3F3F3F : 0x3A404A, accent = projector ? 0xFFC400 : 0x4C9BE8;
  colors[ImGuiCol_Text] = color(projector ? 0xFFFFFF : 0xE6E8EB);
  colors[ImGuiCol_TextDisabled] = color(projector ? 0xC8C8C8 : 0x98A0AB);
  // The window's own background is theirs: a panel fills no pixel twice.
  colors[ImGuiCol_WindowBg] = color(ground, 0);
  colors[ImGuiCol_PopupBg] = color(ground, 0.97f);
  colors[ImGuiCol_Border] = color(high);
  for (const int i : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_Tab})
    colors[i] = color(raised);
  for (const int i : {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered,
                      ImGuiCol_HeaderHovered, ImGuiCol_TabHovered})
    colors[i] = color(high);
  for (const int i : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_CheckMark,
                      ImGuiCol_NavHighlight, ImGuiCol_ButtonActive})
    colors[i] = color(accent);
  colors[ImGuiCol_HeaderActive] = colors[ImGuiCol_TabActive] = color(accent, 0.45f);
  colors[ImGuiCol_Header] = color(accent, 0.35f);
  colors[ImGuiCol_ScrollbarBg] = color(ground);
  colors[ImGuiCol_Separator] = color(high);
}

}  // namespace

std::array<float, 3> ground_of(Style style) {
  const ImVec4 ground = color(ground_rgb(style));
  return {ground.x, ground.y, ground.z};
}

ImTextureID texture_id(const gl::ShownPicture& picture, gl::ScreenBatch::Alpha alpha) {
  const std::uintptr_t bit = alpha == gl::ScreenBatch::Alpha::ignored ? 1 : 0;
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.texture()) * 2 + bit);
}

Interface::Interface(gl::Graphics& graphics)
    : graphics_(graphics), imgui_(ImGui::CreateContext()), fonts_(graphics) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written beside the user's files
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  map_keys(io);
}

Interface::~Interface() { ImGui::DestroyContext(imgui_); }

void Interface::set_style(Style style, double scale) {
  scale = std::clamp(scale, 0.5, 4.0);
  if (style_ == style && scale_ == scale) return;
  style_ = style;
  scale_ = scale;
  ImGui::GetStyle() = ImGuiStyle();
  set_colors(style);
  const double height = (style == Style::desk ? text_height : projector_height) * scale;
  ImGuiStyle& look = ImGui::GetStyle();
  // What a panel costs in software is its triangles, half a microsecond each: round corners and
  // smoothed borders are most of them.
  look.AntiAliasedFill = look.AntiAliasedLines = look.AntiAliasedLinesUseTex = false;
  look.WindowBorderSize = 0;
  look.WindowPadding = {12, 10};
  look.ItemSpacing = {8, 6};
  look.FramePadding = {6, 4};
  look.ScrollbarSize = 12;
  look.ScaleAllSizes(static_cast<float>(height / text_height));
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  font("DejaVuSans.ttf", height);
  code_ = font("DejaVuSansMono.ttf", height * 0.9);
  small_ = font("DejaVuSans.ttf", text_height * scale);
  upload_fonts();
}

void Interface::upload_fonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  image::Image picture(width, height);
  // ImGui's first row has v = 0, as GL's has; a picture's is its top.
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    std::memcpy(picture.rgba.data() + (static_cast<std::size_t>(height) - 1 - y) * row,
                pixels + y * row, row);
  }
  fonts_.upload(picture);
  drawn_.clear();
  ImGui::GetIO().Fonts->SetTexID(texture_id(fonts_, gl::ScreenBatch::Alpha::blended));
}

void Interface::take(const context::Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  const auto modifiers = [&io](const context::Modifiers& held) {
    io.KeyShift = held.shift;
    io.KeyCtrl = held.control;
    io.KeyAlt = held.alt;
  };
  if (const auto* key = std::get_if<context::KeyEvent>(&event)) {
    modifiers(key->modifiers);
    const int index = key->key == Key::character ? key->character & 127 : index_of(key->key);
    hold(io.KeysDown, index, key->press != context::Press::up, keys_down_, keys_up_);
  } else if (const auto* typed = std::get_if<context::Typed>(&event)) {
    io.AddInputCharacter(static_cast<unsigned>(typed->character));
  } else if (const auto* at = std::get_if<context::PointerAt>(&event)) {
    io.MousePos = {static_cast<float>(at->x), static_cast<float>(at->y)};
  } else if (const auto* button = std::get_if<context::ButtonEvent>(&event)) {
    modifiers(button->modifiers);
    hold(io.MouseDown, static_cast<int>(button->button), button->press != context::Press::up,
         buttons_down_, buttons_up_);
  } else if (const auto* scrolled = std::get_if<context::Scrolled>(&event)) {
    // Ctrl as it was at the wheel: by the next frame it may have been let go.
    if (scrolled->modifiers.control) {
      zooming_ += scrolled->y;
    } else {
      io.MouseWheelH += static_cast<float>(scrolled->x);
      io.MouseWheel += static_cast<float>(scrolled->y);
    }
  } else if (std::holds_alternative<context::PointerLeft>(event)) {
    if (!ImGui::IsAnyMouseDown()) io.MousePos = {-FLT_MAX, -FLT_MAX};
  } else if (std::holds_alternative<context::FocusLost>(event)) {
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    modifiers({});
    io.AddFocusEvent(false);
  }
}

void Interface::begin(context::Size size, double seconds) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
  io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
  if (!style_) set_style(Style::desk, 1);
  zoomed_ = std::exchange(zooming_, 0);
  ImGui::NewFrame();
  let_go(io.KeysDown, keys_down_, keys_up_);
  let_go(io.MouseDown, buttons_down_, buttons_up_);
}

void Interface::draw(gl::Screen& screen, const ImDrawList& list) {
  batches_.clear();
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const auto id = reinterpret_cast<std::uintptr_t>(command.GetTexID());
    batches_.push_back(
        {static_cast<GLuint>(id / 2),
         id % 2 ? gl::ScreenBatch::Alpha::ignored : gl::ScreenBatch::Alpha::blended,
         {command.ClipRect.x, command.ClipRect.y, command.ClipRect.z, command.ClipRect.w},
         command.IdxOffset,
         command.ElemCount,
         command.VtxOffset});
  }
  const auto vertices = static_cast<std::size_t>(list.VtxBuffer.Size);
  screen.draw({{reinterpret_cast<const gl::ScreenVertex*>(list.VtxBuffer.Data), vertices},
               {list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size)},
               batches_});
}

void Interface::end(gl::Screen& screen, Pictures pictures) {
  ImGui::Render();
  const ImVec2 size = ImGui::GetDrawData()->DisplaySize;
  const std::array<int, 4> all{0, 0, static_cast<int>(size.x), static_cast<int>(size.y)};
  const auto parts =
      parts_of(*ImGui::GetDrawData(), texture_id(fonts_, gl::ScreenBatch::Alpha::blended));
  const auto damaged = screen.kept() ? damage(drawn_, parts, pictures) : std::nullopt;
  if (damaged) {
    for (const auto& [index, ground] : *damaged) {
      for (const Rectangle& r : ground) {
        const auto x = static_cast<int>(r.x), y = static_cast<int>(r.y);
        screen.clear({std::max(x, 0), std::max(y, 0),
                      std::min(x + static_cast<int>(r.width), all[2]),
                      std::min(y + static_cast<int>(r.height), all[3])});
      }
      for (const ImDrawList* const list : parts[index].lists) draw(screen, *list);
    }
  } else {
    if (screen.kept()) screen.clear(all);
    for (const Part& part : parts)
      for (const ImDrawList* const list : part.lists) draw(screen, *list);
  }
  drawn_ = drawn(parts);
  screen.finish();
}

}  // namespace shadowlab::live
