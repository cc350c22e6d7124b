#include "lua/sandbox_alarm.h"

#include <pthread.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigevent is POSIX
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lua/sandbox_budget.h"

namespace shadowlab::lua {
namespace {

constexpr long period_ns = 20'000'000;

// A signal tells its handler only which thread it interrupts: this is where the thread's budget is.
thread_local Budget* volatile watched = nullptr;

int signal_number() { return SIGRTMIN + 7; }

void on_signal(int) {
  const int saved = errno;
  if (Budget* const budget = watched) budget->tick();
  errno = saved;
}

bool install() {
#ifdef __SANITIZE_THREAD__
  return false;  // it delivers signals only between calls that it knows of: never in a loop of Lua
#else
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // a file that is being read stays readable
  sigemptyset(&action.sa_mask);
  return sigaction(signal_number(), &action, nullptr) == 0;
#endif
}

bool start_timer(timer_t& timer) {
  sigevent event;
  std::memset(&event, 0, sizeof event);
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = signal_number();
  event._sigev_un._tid = gettid();  // glibc 2.36 has no public name for it
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) return false;
  const itimerspec every = {.it_interval = {0, period_ns}, .it_value = {0, period_ns}};
  timer_settime(timer, 0, &every, nullptr);
  return true;
}

}  // namespace

bool Alarm::works() {
  static const bool works = [] {
    timer_t timer{};
    if (!install() || !start_timer(timer)) return false;
    timer_delete(timer);
    return true;
  }();
  return works;
}

Alarm::Alarm(Budget& budget) : before_(watched) {
  watched = &budget;
  if (budget.counts()) return;
  set_ = start_timer(timer_);
  if (!set_) budget.start_counting();  // too many signals are pending: slower, but as safe
}

Alarm::~Alarm() {
  if (set_) timer_delete(timer_);
  watched = before_;
}

}  // namespace shadowlab::lua
