// A clock that interrupts a running script.
#pragma once

#include <ctime>

namespace shadowlab::lua {

class Budget;

/// While it lives, the budget's `tick` is called in this thread every 20 ms, between any two
/// machine instructions: by a timer's signal, which Lua allows to set hooks. So a script that
/// nothing interrupts pays nothing for being watched.
class Alarm {
 public:
  explicit Alarm(Budget& budget);
  ~Alarm();
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

  /// Whether this build and this machine have such clocks.
  static bool works();

 private:
  Budget* before_;  // whose alarm this one interrupts
  timer_t timer_{};
  bool set_ = false;
};

}  // namespace shadowlab::lua
