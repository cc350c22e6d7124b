// The machine that figures were taken on.
#pragma once

#include "gl/graphics.h"
#include "measure/record.h"

namespace shadowlab::measure {

/// Processor, cores, memory, system, driver and its threads, shadowlab's version, the load when
/// asked. What the system does not tell is "unknown" or 0.
Json machine_of(const gl::Graphics& graphics);

}  // namespace shadowlab::measure
