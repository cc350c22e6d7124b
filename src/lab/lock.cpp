#include "lab/lock.h"

#include <linux/landlock.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>

#include "lab/channel.h"

#include <fcntl.h>

namespace shadowlab::lab {
namespace {

// AddressSanitizer maps terabytes, so under it address space has no limit.
#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

bool limit(__rlimit_resource which, rlim_t most) {
  const rlimit both{most, most};
  return ::setrlimit(which, &both) == 0;
}

// The address space that this process has now, in bytes.
rlim_t address_space() {
  rlim_t pages = 0;
  // Where there is no /proc: more than a driver takes.
  if (!(std::ifstream("/proc/self/statm") >> pages)) return rlim_t{1} << 30;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

bool set_limits(const Lock& lock) {
  const auto seconds = static_cast<rlim_t>(std::ceil(lock.seconds));
  bool all = limit(RLIMIT_CPU, seconds);
  if (!sanitized) all &= limit(RLIMIT_AS, address_space() + lock.memory);
  for (const auto which :
       {RLIMIT_FSIZE, RLIMIT_CORE, RLIMIT_NPROC, RLIMIT_MEMLOCK, RLIMIT_MSGQUEUE})
    all &= limit(which, 0);
  return limit(RLIMIT_NOFILE, 32) && all;
}

// Landlock (Linux 5.13) has no wrappers in glibc.
bool set_file_rules(const Lock& lock) {
  constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  // Every right that the first version knows: those that are not granted below are denied.
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
  const Descriptor ruleset(
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0)));
  if (!ruleset.is_open()) return false;
  for (const auto& path : lock.readable) {
    const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
    if (!place.is_open()) continue;
    landlock_path_beneath_attr rule{};
    rule.allowed_access =
        std::filesystem::is_directory(path) ? reading : std::uint64_t{LANDLOCK_ACCESS_FS_READ_FILE};
    rule.parent_fd = place.number();
    if (::syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0))
      return false;
  }
  return ::syscall(SYS_landlock_restrict_self, ruleset.number(), 0) == 0;
}

extern "C" void on_fatal_signal(int signal) {
  // Memory is out when not even this much of it is to be had; the dying process needs none.
  constexpr std::size_t little = std::size_t{32} << 20;
  if (::mmap(nullptr, little, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
    ::_exit(out_of_memory);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

std::string names_of(const Layers& layers, bool that_hold) {
  std::string names;
  const auto add = [&](bool holds, const char* name) {
    if (holds == that_hold) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add(layers.namespaces, "namespaces");
  add(layers.landlock, "file rules");
  add(layers.filter, "system-call filter");
  add(layers.limits, "limits");
  return names;
}

Layers lock_in(const Lock& lock, const SystemCallFilter& filter) {
  Layers layers;
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // no process of the same user looks into it
  layers.limits = set_limits(lock);      // while it may still read how much memory it has
  layers.landlock = set_file_rules(lock);
  layers.filter = filter.hold();
  return layers;
}

void end_when_out_of_memory() {
  if (sanitized) return;                 // it has its own words for a crash
  static std::array<char, 16384> stack;  // for a handler that runs when the stack is what is full
  const stack_t there{stack.data(), 0, stack.size()};
  ::sigaltstack(&there, nullptr);
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = on_fatal_signal;
  action.sa_flags = SA_ONSTACK | SA_NODEFER | SA_RESETHAND;
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE})
    ::sigaction(signal, &action, nullptr);
}

}  // namespace shadowlab::lab
