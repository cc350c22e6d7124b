// What is in the window, said anew each frame from the studio and the view.
#pragma once

#include "live/interface.h"
#include "live/studio.h"
#include "live/view.h"

namespace shadowlab::live {

/// Everything, between Interface::begin and end. What the pointer does in panels and picture
/// changes `studio` and `view`.
void draw_window(Studio& studio, View& view, const Interface& interface);

/// Its parts.
void draw_picture(Studio& studio, View& view, const Interface& interface, const Rectangle& area);
/// Whether a pixel of the picture is large enough for its numbers, in the type that is set.
bool shows_numbers(const PictureView& picture);
/// Those of a picture of that size, over it.
void draw_numbers(const Studio& studio, const View& view, int width, int height);
/// The truth as draw_picture drew the picture, in another place.
void draw_truth_beside(const Studio& studio, const View& view, const Rectangle& area);
/// The mark of the light over everything in the picture's place; after draw_picture.
void draw_light(const Studio& studio, const View& view);
void draw_parameters(Studio& studio, View& view);
void draw_passes(Studio& studio, View& view, const Interface& interface);
void draw_failure(const Failure& failure, const Interface& interface, const Rectangle& area);
void draw_help(Studio& studio, View& view, const Interface& interface);

/// A window of ImGui that is a place of ours: nothing about it moves. True, as ImGui::Begin.
enum class Scrolling { yes, no };
bool begin_place(const char* name, const Rectangle& area, Scrolling scrolls = Scrolling::yes);

/// The width of a line that is so many pixels wide on a screen of single density on a desk.
float stroke(float pixels);

/// A flat button that stays down while it is chosen: a circle to tick has thirty times its
/// triangles.
bool choice(const char* name, bool chosen);

}  // namespace shadowlab::live
