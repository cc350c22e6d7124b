#pragma once

#include <filesystem>
#include <string_view>

namespace shadowlab {

std::string_view version();

/// The folder that holds scripts/, shaders/ and labs/: $SHADOWLAB_HOME, else the folder that the
/// program was built from. Throws MachineError where neither holds them.
std::filesystem::path home();

}  // namespace shadowlab
