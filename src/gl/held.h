// What GL holds for a context: its objects and their bytes, asked of GL itself.
#pragma once

#include <cstdint>

#include "gl/functions.h"

namespace shadowlab::gl {

struct Holding {
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
};

struct Held {
  Holding buffers;
  Holding textures;  ///< all levels and faces
  Holding renderbuffers;
};

/// All buffers, textures and renderbuffers of the current context, the core's and the recipe's. The
/// bytes are those of the formats; what a driver adds is its own. Bindings are as they were.
Held held(const Functions& gl);

}  // namespace shadowlab::gl
