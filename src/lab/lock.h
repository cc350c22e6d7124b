// How the process that draws a submission locks itself in, before it reads a line of it.
#pragma once

#include <filesystem>
#include <vector>

#include "lab/layers.h"
#include "lab/system_calls.h"

namespace shadowlab::lab {

struct Lock {
  double seconds = 10;                          ///< of processor time
  std::size_t memory = std::size_t{1} << 30;    ///< bytes of address space beyond what it has now
  std::vector<std::filesystem::path> readable;  ///< files and folders
};

/// Takes from the calling process, for good, whatever drawing does not need; gives what holds (the
/// namespaces are not its business). It must have one thread, and no descriptor that it may not
/// use.
Layers lock_in(const Lock& lock, const SystemCallFilter& filter);

/// A process that ran out of address space ends with this code, in place of the signal that it
/// dies of, from here on.
inline constexpr int out_of_memory = 101;
void end_when_out_of_memory();

}  // namespace shadowlab::lab
