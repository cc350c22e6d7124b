#include "hostile.h"

#include <fcntl.h>
#include <linux/perf_event.h>
#include <linux/sched.h>
#include <netinet/in.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include "lab/channel.h"
#include "lab/wire.h"
#include "lab/zygote.h"

namespace shadowlab::sandbox_tests {
namespace {

using namespace lab;
using wire::Bytes;

// An attack says whether it got what it wanted; most do not come back.
using Attack = std::function<bool(int channel, const Job& job)>;

bool opens(const char* file, int flags) { return ::open(file, flags, 0666) >= 0; }

Bytes drawing_of(const Job& job, std::size_t shot) {
  Drawing drawing;
  drawing.frame.color = image::Image(job.width, job.height);
  return wire::message_of(shot, drawing);
}

// So many bytes of it, again and again, until nobody takes them.
bool pours(int descriptor, std::size_t size) {
  const Bytes block(size, 'x');
  while (::write(descriptor, block.data(), block.size()) > 0) {
  }
  return false;
}

bool sends(int channel, std::initializer_list<Bytes> messages) {
  for (const Bytes& message : messages) write_all(channel, message);
  return false;
}

Bytes with_length(Bytes message, std::uint64_t length) {
  std::memcpy(message.data() + 8, &length, sizeof length);
  return message;
}

int deep(int n) {
  volatile char frame[4096] = {};
  frame[0] = 1;
  return n == 0 ? frame[1] : deep(n + 1) + frame[0];
}

bool starts_a_thread() {
  pthread_t thread{};
  return ::pthread_create(
             &thread, nullptr, [](void*) -> void* { return nullptr; }, nullptr) == 0;
}

const std::map<std::string, Attack>& attacks() {
  static const std::map<std::string, Attack> all{
      // Out of the process.
      {"forks", [](int, const Job&) { return ::fork() >= 0; }},
      {"forks_by_hand",
       [](int, const Job&) { return ::syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) >= 0; }},
      {"forks_by_clone3",
       [](int, const Job&) {
         clone_args arguments{};
         arguments.exit_signal = SIGCHLD;
         return ::syscall(SYS_clone3, &arguments, sizeof arguments) >= 0;
       }},
      {"starts_a_thread", [](int, const Job&) { return starts_a_thread(); }},
      {"runs_a_program",
       [](int, const Job&) { return ::execl("/bin/sh", "sh", "-c", "id", nullptr) == 0; }},
      {"kills_its_parent", [](int, const Job&) { return ::kill(::getppid(), SIGKILL) == 0; }},
      {"kills_everybody", [](int, const Job&) { return ::kill(-1, SIGKILL) == 0; }},
      {"signals_a_thread_of_another",
       [](int, const Job&) {
         return ::syscall(SYS_tgkill, ::getppid(), ::getppid(), SIGKILL) == 0;
       }},
      {"traces_its_parent",
       [](int, const Job&) { return ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr) == 0; }},
      {"reads_its_parents_memory",
       [](int, const Job&) {
         char byte = 0;
         iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
         return ::process_vm_readv(::getppid(), &here, 1, &there, 1, 0) == 1;
       }},
      {"opens_a_socket", [](int, const Job&) { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
      {"opens_a_local_socket",
       [](int, const Job&) { return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
      {"makes_namespaces",
       [](int, const Job&) { return ::syscall(SYS_unshare, CLONE_NEWUSER) == 0; }},
      {"mounts",
       [](int, const Job&) { return ::syscall(SYS_mount, "x", "/", "tmpfs", 0, 0) == 0; }},
      {"sets_up_io_uring", [](int, const Job&) { return ::syscall(425, 8, nullptr) >= 0; }},
      {"loads_bpf", [](int, const Job&) { return ::syscall(SYS_bpf, 0, nullptr, 0) >= 0; }},
      {"watches_counters",
       [](int, const Job&) {
         perf_event_attr attributes{};
         return ::syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0) >= 0;
       }},
      {"shares_memory", [](int, const Job&) { return ::syscall(SYS_shmget, 1, 4096, 0666) >= 0; }},
      {"takes_another_user", [](int, const Job&) { return ::setuid(0) == 0; }},
      {"keeps_keys", [](int, const Job&) { return ::syscall(SYS_keyctl, 0, -3, 0) >= 0; }},
      // Files.
      {"writes_a_file", [](int, const Job&) { return opens("results.json", O_WRONLY | O_CREAT); }},
      {"writes_in_tmp", [](int, const Job&) { return opens("/tmp/owned", O_RDWR | O_CREAT); }},
      {"writes_over_its_recipe",
       [](int, const Job& job) { return opens(job.recipe.c_str(), O_WRONLY | O_TRUNC); }},
      {"makes_a_nameless_file", [](int, const Job&) { return opens("/tmp", O_TMPFILE | O_RDWR); }},
      {"makes_a_folder", [](int, const Job&) { return ::mkdir("/tmp/owned", 0777) == 0; }},
      {"removes_its_recipe", [](int, const Job& job) { return ::unlink(job.recipe.c_str()) == 0; }},
      {"makes_a_link", [](int, const Job&) { return ::symlink("/etc/passwd", "link.lua") == 0; }},
      {"reads_passwd", [](int, const Job&) { return opens("/etc/passwd", O_RDONLY); }},
      {"reads_its_parents_environment",
       [](int, const Job&) {
         return opens(("/proc/" + std::to_string(::getppid()) + "/environ").c_str(), O_RDONLY);
       }},
      {"lists_the_submissions",
       [](int, const Job&) { return opens("..", O_RDONLY | O_DIRECTORY); }},
      {"raises_its_limits",
       [](int, const Job&) {
         const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
         return ::setrlimit(RLIMIT_AS, &none) == 0;
       }},
      // The protocol.
      {"sends_noise", [](int channel, const Job&) { return sends(channel, {Bytes(64, 'x')}); }},
      {"sends_a_job",
       [](int channel, const Job& job) { return sends(channel, {wire::message_of(job)}); }},
      {"sends_a_length_of_2_to_63",
       [](int channel, const Job& job) {
         return sends(channel, {with_length(drawing_of(job, 0), std::uint64_t{1} << 63)});
       }},
      {"sends_another_size",
       [](int channel, Job job) {
         job.width *= 2;
         return sends(channel, {drawing_of(job, 0)});
       }},
      {"sends_a_shot_twice",
       [](int channel, const Job& job) {
         return sends(channel, {drawing_of(job, 0), drawing_of(job, 0), wire::done_message()});
       }},
      {"says_done_at_once",
       [](int channel, const Job&) { return sends(channel, {wire::done_message()}); }},
      {"goes_on_after_the_end",
       [](int channel, const Job& job) {
         return sends(channel, {drawing_of(job, 0), drawing_of(job, 1), wire::done_message(),
                                wire::done_message()});
       }},
      {"sends_half_a_message",
       [](int channel, const Job& job) {
         Bytes message = drawing_of(job, 0);
         message.resize(message.size() / 2);
         sends(channel, {message});
         ::_exit(0);
         return false;
       }},
      {"pours_into_the_channel",
       [](int channel, const Job& job) {
         sends(channel, {with_length(drawing_of(job, 0), std::uint64_t{1} << 27)});
         return pours(channel, std::size_t{1} << 20);
       }},
      {"pours_onto_standard_output", [](int, const Job&) { return pours(STDOUT_FILENO, 65536); }},
      {"pours_onto_standard_error", [](int, const Job&) { return pours(STDERR_FILENO, 65536); }},
      // Its own end.
      {"ends_without_a_word",
       [](int, const Job&) {
         ::_exit(0);
         return false;
       }},
      {"breaks_down",
       [](int, const Job&) {
         std::raise(SIGSEGV);
         return false;
       }},
      {"aborts",
       [](int, const Job&) {
         std::abort();
         return false;
       }},
      {"kills_itself",
       [](int, const Job&) {
         std::raise(SIGKILL);
         return false;
       }},
      {"overflows_its_stack", [](int, const Job&) { return deep(1) != 0; }},
      {"takes_all_memory",
       [](int, const Job&) {
         while (true) {
           void* const block = std::malloc(std::size_t{1} << 24);
           std::memset(block, 1, std::size_t{1} << 24);
         }
         return true;
       }},
      {"closes_all_and_spins",
       [](int, const Job&) {
         for (int i = 0; i < 32; ++i) ::close(i);
         while (true) {
         }
         return true;
       }},
      {"sleeps",
       [](int, const Job&) {
         while (true) ::sleep(100);
         return true;
       }},
      {"ignores_all_signals", [](int, const Job&) {
         for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
         while (true) {
         }
         return true;
       }}};
  return all;
}

void live(gl::Graphics&, int channel) {
  std::array<std::uint8_t, wire::header_size> head{};
  if (!read_all(channel, head)) return;
  Bytes body(wire::header_from(head).length);
  if (!read_all(channel, body)) return;
  const Job job = wire::job_from(body);
  const bool succeeded = attacks().at(job.recipe.stem().string())(channel, job);
  const std::string_view said = succeeded ? "it succeeded" : "it was refused";
  (void)!::write(STDERR_FILENO, said.data(), said.size());
  ::_exit(1);
}

}  // namespace

int serve_hostile(int argc, char** argv) {
  ZygoteOptions options{.width = 16, .height = 8};
  for (int i = 2; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--namespaces") options.namespaces = true;
  }
  serve(options, live);
  return 0;
}

}  // namespace shadowlab::sandbox_tests
