// What of a window has to be drawn again, where its last frame is still there.
//
// In software a panel's triangles cost more than the saying of them, and from one frame to the next
// only the picture and a number or two change: so a panel that says what it said stays as it is.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "live/picture_view.h"

namespace shadowlab::live {

/// A window of ImGui with the children in it, as it is drawn in one frame.
struct Part {
  std::string_view name;
  std::vector<const ImDrawList*> lists;
  std::size_t contents = 0;     ///< a hash of its triangles
  Rectangle box;                ///< around them, in whole pixels
  bool shows_pictures = false;  ///< textures that may change by themselves
  Rectangle covered;            ///< what a picture hides of the ground
};

/// The parts of a frame, in the order in which they are drawn. `letters` is the texture that never
/// changes.
std::vector<Part> parts_of(const ImDrawData& frame, ImTextureID letters);

/// What is known of a part after its frame.
struct DrawnPart {
  std::string name;
  std::size_t contents;
  Rectangle box;
};
std::vector<DrawnPart> drawn(const std::vector<Part>& parts);

enum class Pictures { may_have_changed, as_they_were };

/// A part to be drawn again, and what of the ground has to be cleared before.
struct Damage {
  std::size_t part = 0;
  std::vector<Rectangle> ground;
};
/// Nothing where the whole frame has to be: a part came or went, or one that changed touches
/// another.
std::optional<std::vector<Damage>> damage(const std::vector<DrawnPart>& before,
                                          const std::vector<Part>& now, Pictures pictures);

}  // namespace shadowlab::live
