// How the window shows the studio: what is open, how large, what is selected.
#pragma once

#include <cstddef>
#include <string>

#include "context/window.h"
#include "live/interface.h"
#include "live/overlay.h"
#include "live/picture_view.h"
#include "live/readings.h"

namespace shadowlab::live {

struct View {
  bool open = true;
  bool renewed = false;  ///< another window and context are to take the place of these
  bool panels = true;
  bool help = false;
  Style style = Style::desk;
  context::Extent extent = context::Extent::windowed;
  Overlay overlay = Overlay::none;
  OverlayShapes shapes;
  PictureView picture;
  Readings readings;
  double slider = 0.5;        ///< right of it is the truth: of the picture's width
  bool slides = false;        ///< the pointer holds it
  std::size_t caster = 0;     ///< the one that the keys are about
  int scrolls = 0;            ///< lines that the details are to go on by
  std::size_t parameter = 0;  ///< the one that the keys are about
  bool window_shot = false;   ///< the window itself is to go into a file
  enum class Details { state, calls, pixel, count } details = Details::state;
};

}  // namespace shadowlab::live
