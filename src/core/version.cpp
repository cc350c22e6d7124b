#include "core/version.h"

#include <cstdlib>
#include <string>

#include "core/error.h"

namespace shadowlab {

std::string_view version() { return SHADOWLAB_VERSION; }

std::filesystem::path home() {
  const char* given = std::getenv("SHADOWLAB_HOME");
  std::filesystem::path folder = given ? given : SHADOWLAB_SOURCE_DIR;
  std::error_code none;
  if (!std::filesystem::is_directory(folder / "scripts", none)) {
    throw MachineError("shadowlab's scripts are not in " + folder.string() +
                       "; set SHADOWLAB_HOME to the folder that holds scripts/ and shaders/.");
  }
  return folder;
}

}  // namespace shadowlab
