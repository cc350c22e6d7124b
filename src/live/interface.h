// Dear ImGui over our own window and our own GL: events in, triangles out.
//
// ImGui's stock backends link to a window system and to a GL of their own; here the first is
// context/'s and the second goes through gl/'s table, so the interface draws in any context, also
// where tests look at it without a window.
#pragma once

#include <imgui.h>

#include <array>
#include <optional>
#include <vector>

#include "context/window.h"
#include "gl/screen.h"
#include "live/damage.h"

namespace shadowlab::live {

/// How panels look: on a desk, or on a projector across a room.
enum class Style { desk, projector };
/// The colour that the window is filled with: panels have none of their own.
std::array<float, 3> ground_of(Style style);

class Interface {
 public:
  explicit Interface(gl::Graphics& graphics);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Type and spacing for a screen of that density. Not between `begin` and `end`.
  void set_style(Style style, double scale);

  void take(const context::Event& event);
  void begin(context::Size size, double seconds);
  /// Draws what the panels said since `begin`, or of it what differs from what `screen` shows.
  void end(gl::Screen& screen, Pictures pictures = Pictures::may_have_changed);

  /// Whether a text field has the keyboard.
  bool types() const { return ImGui::GetIO().WantTextInput; }
  /// Type in a fixed width, for code and numbers.
  ImFont* code() const { return code_; }
  /// Type of the desk's size in any style: for what would not fit otherwise.
  ImFont* small() const { return small_; }
  /// Notches of the wheel with Ctrl, which are no scrolling.
  double zoomed() const { return zoomed_; }

 private:
  void upload_fonts();
  void draw(gl::Screen& screen, const ImDrawList& list);

  gl::Graphics& graphics_;
  ImGuiContext* imgui_;
  gl::ShownPicture fonts_;
  ImFont* code_ = nullptr;
  ImFont* small_ = nullptr;
  double zooming_ = 0, zoomed_ = 0;  ///< since `begin`, and before it
  std::optional<Style> style_;
  double scale_ = 0;
  std::vector<gl::ScreenBatch> batches_;
  std::vector<DrawnPart> drawn_;  ///< of the last frame
  // ImGui looks at keys and buttons once a frame: what went down and up between two looks is held
  // until it has seen it.
  std::vector<int> keys_down_, keys_up_;
  std::vector<int> buttons_down_, buttons_up_;
};

/// What ImGui::Image takes. A recipe's picture ignores its alpha, as a window does.
ImTextureID texture_id(const gl::ShownPicture& picture,
                       gl::ScreenBatch::Alpha alpha = gl::ScreenBatch::Alpha::ignored);

}  // namespace shadowlab::live
