// The layers between a submission and this machine.
#pragma once

#include <string>

namespace shadowlab::lab {

/// Which of them hold. Each is enough against most of what a submission can try, and no machine
/// has to have them all: containers often refuse namespaces, old kernels know no Landlock.
struct Layers {
  bool namespaces = false;  ///< of its own, by bubblewrap: no network, no other files or processes
  bool landlock = false;    ///< the kernel lets it read its recipe, scripts/ and shaders/ alone
  bool filter = false;      ///< seccomp: no call to the system that drawing does not need
  bool limits = false;      ///< rlimits: memory, processor time, no files written, no processes

  bool operator==(const Layers&) const = default;
};

/// "namespaces, file rules, system-call filter, limits": those that hold, or those that do not.
std::string names_of(const Layers& layers, bool that_hold = true);

}  // namespace shadowlab::lab
