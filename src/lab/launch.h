// How a worker's process is started: internal to this floor.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "lab/channel.h"
#include "lab/layers.h"
#include "lab/worker.h"

namespace shadowlab::lab {

/// A worker that serves. It ends when `control` is closed; whoever has it waits for `process`.
struct Launched {
  pid_t process = -1;
  Descriptor control;
  Layers layers;
  std::string renderer;
};

/// Starts a worker that sees `submissions`, a folder, besides what every worker sees: in namespaces
/// of its own where the isolation wants them and bubblewrap can make them. Throws MachineError, one
/// sentence.
Launched launch(const Isolation& isolation, const std::filesystem::path& submissions);

/// Ends it, and every child of it, now.
void end(Launched& launched);

}  // namespace shadowlab::lab
