#pragma once

namespace shadowlab::context {

/// While it exists, drivers and their loaders say nothing on standard error: they warn about every
/// driver that they try in vain and about a cache folder that they cannot make, and then go on.
/// Other threads are silenced too. Nothing is silenced where LIBGL_DEBUG, EGL_LOG_LEVEL or
/// MESA_DEBUG is set.
class DriverSilence {
 public:
  DriverSilence();
  DriverSilence(const DriverSilence&) = delete;
  DriverSilence& operator=(const DriverSilence&) = delete;
  ~DriverSilence();

 private:
  int standard_error_ = -1;  // a duplicate of it; -1: nothing is silenced
};

}  // namespace shadowlab::context
