#include <dlfcn.h>

#include <utility>

#include "context/native.h"

namespace shadowlab::context {

SharedLibrary::SharedLibrary(std::string subject, std::string file, const std::string& package)
    : subject_(std::move(subject)), file_(std::move(file)) {
  // RTLD_LOCAL: libOSMesa and libGL export the same gl* names.
  library_ = dlopen(file_.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (library_) return;
  const char* message = dlerror();
  const std::string why = message ? message : "for no stated reason";
  // The loader begins with the file that it looked for: this one, or one that this one needs.
  const bool missing = why.starts_with(file_) && why.find("No such file") != std::string::npos;
  if (missing) {
    throw Unavailable(subject_ + ": " + file_ + " is not installed",
                      "install it with apt-get install " + package);
  }
  throw Unavailable(subject_ + ": " + file_ + " does not load (" + why + ")",
                    "install it anew with apt-get install --reinstall " + package);
}

void* SharedLibrary::symbol(const char* name) const {
  if (void* found = dlsym(library_, name)) return found;
  throw Unavailable(subject_ + ": " + file_ + " has no " + name, "a newer version of it is needed");
}

}  // namespace shadowlab::context

// Leak checks count what an unloaded library's globals still pointed at as lost, and GLFW and libGL
// unload drivers: under them nothing is unloaded.
#ifdef __SANITIZE_ADDRESS__
extern "C" int dlclose(void*) noexcept { return 0; }
#endif
