// What a backend provides: internal to this floor.
#pragma once

#include <memory>
#include <string>

#include "context/context.h"
#include "core/error.h"

namespace shadowlab::context {

/// A window system's context. It is not current when it is made; the destructor must not be called
/// while it is current on another thread.
class Native {
 public:
  Native() = default;
  Native(const Native&) = delete;
  Native& operator=(const Native&) = delete;
  virtual ~Native() = default;

  /// Called only when no other backend's context is current on this thread: they share libglapi's
  /// or libGLdispatch's idea of the current context.
  virtual void make_current() = 0;
  virtual void release() = 0;
  virtual Function function(const char* gl_name) const = 0;
  /// As Context::name. Called while current.
  virtual std::string name() const = 0;
  /// As Context::window.
  virtual Window* window() { return nullptr; }
};

/// Why a backend does not work: "BACKEND: REASON; REMEDY." where there is a remedy.
class Unavailable : public MachineError {
 public:
  Unavailable(std::string reason, std::string remedy = {});
  std::string reason;  ///< begins with the backend's name and has no stop: "OSMesa: … is missing"
  std::string remedy;
};

std::unique_ptr<Native> make_osmesa(Size size);
std::unique_ptr<Native> make_egl(Size size);
std::unique_ptr<Native> make_glfw(Size size);
std::unique_ptr<Native> make_glfw_window(const WindowOptions& options);

/// A library loaded at run time. It stays loaded: Mesa's threads and exit handlers outlive a
/// context.
class SharedLibrary {
 public:
  /// Throws Unavailable, in the name of `subject` ("OSMesa"), with the Debian package to install.
  SharedLibrary(std::string subject, std::string file, const std::string& package);
  /// Throws Unavailable where the library has no such function.
  template <typename F>
  void find(F*& function, const char* name) const {
    function = reinterpret_cast<F*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  std::string subject_;
  std::string file_;
  void* library_;
};

}  // namespace shadowlab::context
