#include "context/driver_silence.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace shadowlab::context {

DriverSilence::DriverSilence() {
  for (const char* wanted : {"LIBGL_DEBUG", "EGL_LOG_LEVEL", "MESA_DEBUG"}) {
    if (std::getenv(wanted)) return;
  }
  std::fflush(stderr);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  standard_error_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  if (standard_error_ >= 0) ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

DriverSilence::~DriverSilence() {
  if (standard_error_ < 0) return;
  std::fflush(stderr);
  ::dup2(standard_error_, STDERR_FILENO);
  ::close(standard_error_);
}

}  // namespace shadowlab::context
