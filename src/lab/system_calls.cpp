#include "lab/system_calls.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <memory>

#include "lab/channel.h"

namespace shadowlab::lab {
namespace {

// Reading what is open or may be opened, memory, clocks and the timer of Lua's budget, signals to
// itself, ending. llvmpipe's code needs memory that can be run, which mprotect gives.
constexpr std::initializer_list<int> allowed = {
    SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(write), SCMP_SYS(writev),
    SCMP_SYS(lseek), SCMP_SYS(close), SCMP_SYS(dup), SCMP_SYS(dup2), SCMP_SYS(dup3),
    SCMP_SYS(fstat), SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(newfstatat), SCMP_SYS(statx),
    SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(access), SCMP_SYS(faccessat),
    SCMP_SYS(faccessat2), SCMP_SYS(getcwd), SCMP_SYS(getdents64), SCMP_SYS(fadvise64),
    //
    SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mprotect), SCMP_SYS(mremap), SCMP_SYS(madvise),
    SCMP_SYS(brk), SCMP_SYS(futex),
    //
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time),
    SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep), SCMP_SYS(timer_create), SCMP_SYS(timer_settime),
    SCMP_SYS(timer_gettime), SCMP_SYS(timer_getoverrun), SCMP_SYS(timer_delete),
    //
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall), SCMP_SYS(set_robust_list), SCMP_SYS(rseq),
    //
    SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(gettid), SCMP_SYS(getuid), SCMP_SYS(geteuid),
    SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity),
    SCMP_SYS(getcpu), SCMP_SYS(getrandom), SCMP_SYS(getrusage), SCMP_SYS(sysinfo), SCMP_SYS(uname),
    SCMP_SYS(exit), SCMP_SYS(exit_group)};

struct Refused {
  int call;
  int error;
};
// What libraries try and do without.
constexpr std::initializer_list<Refused> refused = {
    {SCMP_SYS(clone3), ENOSYS},  // its flags are out of a filter's reach; glibc then asks by clone
    {SCMP_SYS(openat2), ENOSYS},
    {SCMP_SYS(ioctl), ENOTTY},
    {SCMP_SYS(prctl), EPERM},
    {SCMP_SYS(prlimit64), EPERM},
    {SCMP_SYS(memfd_create), EPERM},
    {SCMP_SYS(membarrier), ENOSYS},
    {SCMP_SYS(sched_setaffinity), EPERM},
    {SCMP_SYS(set_mempolicy), EPERM},
    {SCMP_SYS(get_mempolicy), EPERM},
    {SCMP_SYS(mbind), EPERM}};

constexpr scmp_datum_t changes = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;

struct Release {
  void operator()(void* filter) const { ::seccomp_release(filter); }
};
using Rules = std::unique_ptr<void, Release>;

// As the kernel takes them; none where there was no memory or file for that.
std::vector<sock_filter> program_of(const Rules& rules) {
  const Descriptor file(::memfd_create("filter", MFD_CLOEXEC));
  if (!file.is_open() || ::seccomp_export_bpf(rules.get(), file.number()) != 0) return {};
  const off_t bytes = ::lseek(file.number(), 0, SEEK_END);
  std::vector<sock_filter> program(static_cast<std::size_t>(bytes) / sizeof(sock_filter));
  if (::pread(file.number(), program.data(), program.size() * sizeof(sock_filter), 0) != bytes)
    return {};
  return program;
}

// Of the calls that the list below allows, one only to itself: abort() is a signal. Which process
// that is differs from one to the next.
bool hold_signals_to_itself() {
  const Rules rules(::seccomp_init(SCMP_ACT_ALLOW));
  const auto itself = static_cast<scmp_datum_t>(::getpid());
  return rules &&
         ::seccomp_rule_add(rules.get(), SCMP_ACT_KILL_PROCESS, SCMP_SYS(tgkill), 1,
                            SCMP_A0(SCMP_CMP_NE, itself)) == 0 &&
         ::seccomp_load(rules.get()) == 0;
}

}  // namespace

SystemCallFilter::SystemCallFilter() {
  const Rules filter(::seccomp_init(SCMP_ACT_KILL_PROCESS));
  if (!filter) return;
  scmp_filter_ctx all = filter.get();
  bool good = true;
  // A call that this architecture does not have is none that could be made.
  const auto rule = [&](std::uint32_t action, int call, std::initializer_list<scmp_arg_cmp> when) {
    const int answer = ::seccomp_rule_add_array(all, action, call,
                                                static_cast<unsigned>(when.size()), when.begin());
    good &= answer == 0 || answer == -EDOM;
  };
  for (const int call : allowed) rule(SCMP_ACT_ALLOW, call, {});
#ifdef __SANITIZE_ADDRESS__
  // Its companion for undefined behaviour asks by a pipe whether memory can be read.
  for (const int call : {SCMP_SYS(pipe), SCMP_SYS(pipe2)}) rule(SCMP_ACT_ALLOW, call, {});
#endif
  for (const auto& [call, error] : refused)
    rule(SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), call, {});

  // The channel is open; to anywhere else nothing goes.
  rule(SCMP_ACT_ALLOW, SCMP_SYS(sendto), {SCMP_A4(SCMP_CMP_EQ, 0)});
  // Files are opened for reading alone.
  const auto may_open = [&](int call, unsigned flags) {
    rule(SCMP_ACT_ALLOW, call, {SCMP_CMP(flags, SCMP_CMP_MASKED_EQ, changes, O_RDONLY)});
    for (const scmp_datum_t bit : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC, O_APPEND})
      rule(SCMP_ACT_ERRNO(EACCES), call, {SCMP_CMP(flags, SCMP_CMP_MASKED_EQ, bit, bit)});
  };
  may_open(SCMP_SYS(open), 1);
  may_open(SCMP_SYS(openat), 2);
  // A further thread is refused as where there are too many; a further process is not to be asked
  // for.
  rule(SCMP_ACT_ERRNO(EAGAIN), SCMP_SYS(clone),
       {SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD)});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), {});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1(SCMP_CMP_EQ, F_GETFL)});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1(SCMP_CMP_EQ, F_GETFD)});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1(SCMP_CMP_EQ, F_SETFD)});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1(SCMP_CMP_EQ, F_DUPFD_CLOEXEC)});

  // Lookups by halves rather than one by one: a call costs less.
  ::seccomp_attr_set(all, SCMP_FLTATR_CTL_OPTIMIZE, 2);
  if (good) program_ = program_of(filter);
}

bool SystemCallFilter::hold() const {
  if (program_.empty()) return false;
  // The list itself comes last: under it no further one can be loaded.
  if (!hold_signals_to_itself()) return false;
  const sock_fprog program{static_cast<unsigned short>(program_.size()),
                           const_cast<sock_filter*>(program_.data())};
  return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace shadowlab::lab
