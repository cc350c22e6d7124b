// The window of a live session: its loop, its keys, its title.
#pragma once

#include "live/studio.h"

namespace shadowlab::live {

struct LiveOptions {
  StudioOptions studio;
  int width = 512, height = 512;  ///< of the recipes' pictures
  enum class Panels { shown, hidden } panels = Panels::shown;
};

/// Opens the window and stays until it is closed. Throws MachineError where there is no display.
void show(const LiveOptions& options);

}  // namespace shadowlab::live
