#include "lab/launch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/version.h"
#include "lab/zygote.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Longer than the coldest start with many recipes to warm up with takes.
constexpr int patience_ms = 300'000;

fs::path program_of(const Isolation& isolation) {
  return isolation.program.empty() ? fs::read_symlink("/proc/self/exe")
                                   : fs::absolute(isolation.program);
}

// What a worker's environment has: the choice of a driver, and nothing about who runs it. Its
// driver has no threads and no cache on the disk (zygote.h), and its shaders are not optimized: a
// submission draws a few small pictures, and compiles for them more than it draws. The pixels are
// the same. Its heap grows by large pages (filled_heap.h).
Words environment() {
  Words variables{"LP_NUM_THREADS=0",
                  "MESA_SHADER_CACHE_DISABLE=true",
                  "LIBGL_ALWAYS_SOFTWARE=1",
                  "GALLIVM_PERF=nopt",
                  "GLIBC_TUNABLES=glibc.malloc.hugetlb=1",
                  "LC_ALL=C",
                  "SHADOWLAB_HOME=" + home().string()};
  for (const char* name : {"LD_LIBRARY_PATH", "LP_NATIVE_VECTOR_WIDTH", "GALLIUM_DRIVER",
                           "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name))
      variables.push_back(fmt::format("{}={}", name, value));
  }
  return variables;
}

Words serving(const Isolation& isolation, bool namespaces) {
  Words words{program_of(isolation).string(), "worker",
              fmt::format("--size={}x{}", isolation.width, isolation.height),
              fmt::format("--context={}", context::name_of(isolation.backend))};
  if (namespaces) words.emplace_back("--namespaces");
  if (isolation.warmth == Warmth::states) words.emplace_back("--states");
  for (const fs::path& file : isolation.warm) words.push_back(fs::absolute(file).string());
  return words;
}

enum class Proc { mounted, absent };

// bubblewrap's words: libraries, the program, scripts/ and shaders/, what warms up and the
// submissions' folder can be read, and there is nothing else.
Words in_namespaces(const Isolation& isolation, const fs::path& submissions, Proc proc) {
  Words words{
      "bwrap",         "--unshare-user",       "--unshare-ipc", "--unshare-pid", "--unshare-net",
      "--unshare-uts", "--unshare-cgroup-try", "--new-session", "--cap-drop",    "ALL"};
  const auto show = [&](const fs::path& path, bool must = true) {
    words.insert(words.end(), {must ? "--ro-bind" : "--ro-bind-try", path, path});
  };
  for (const char* folder : {"/usr/lib", "/usr/lib64", "/lib", "/lib64", "/usr/local/lib",
                             "/usr/share/glvnd", "/usr/share/drirc.d", "/etc/ld.so.cache"})
    show(folder, false);
  if (const char* given = std::getenv("LD_LIBRARY_PATH")) {
    for (std::string_view rest = given; !rest.empty();) {
      const std::string_view folder = rest.substr(0, rest.find(':'));
      if (folder.starts_with('/')) show(folder, false);
      rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
  }
  for (const char* device : {"/dev/null", "/dev/urandom"})
    words.insert(words.end(), {"--dev-bind", device, device});
  if (proc == Proc::mounted) words.insert(words.end(), {"--proc", "/proc"});
  show(program_of(isolation));
  show(home() / "scripts");
  show(home() / "shaders");
  for (const fs::path& file : isolation.warm) show(fs::absolute(file));
  show(submissions);
  words.insert(words.end(), {"--remount-ro", "/", "--chdir", "/", "--"});
  for (std::string& word : serving(isolation, true)) words.push_back(std::move(word));
  return words;
}

std::vector<char*> pointers_to(Words& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// The process, with `control` as its descriptor 3 and `words` as its standard error; nothing where
// there is no such program.
std::optional<pid_t> start(Words command, const Descriptor& control, const Descriptor& words) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, words.number(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, control.number(), control_descriptor);
  posix_spawn_file_actions_addclosefrom_np(&actions, control_descriptor + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  // Ctrl-C is for the grader, which ends its workers.
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  Words variables = environment();
  pid_t process = -1;
  const int failed = ::posix_spawnp(&process, command[0].c_str(), &actions, &attributes,
                                    pointers_to(command).data(), pointers_to(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  return process;
}

// What is there to be read now.
std::string words_from(const Descriptor& descriptor) {
  make_nonblocking(descriptor.number());
  std::string words(1000, '\0');
  const ssize_t got = ::read(descriptor.number(), words.data(), words.size());
  words.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return words.substr(0, words.find('\n'));
}

// A worker that greeted, or why there is none.
struct Attempt {
  std::optional<Launched> launched = std::nullopt;
  std::string why_not = {};
};

Attempt attempt(Words command) {
  Ends control = make_messages();
  Ends words = make_pipe();
  // Numbers that are not the ones they get: dup2 onto itself would leave them to be closed.
  for (Descriptor* each : {&control.theirs, &words.theirs})
    *each = Descriptor(::fcntl(each->number(), F_DUPFD_CLOEXEC, 10));
  const std::string program = command[0];
  const auto process = start(std::move(command), control.theirs, words.theirs);
  if (!process) return {.why_not = program + " cannot be started"};
  Launched launched{*process, std::move(control.ours), {}, {}};
  control.theirs.close();
  words.theirs.close();
  pollfd greeting{launched.control.number(), POLLIN, 0};
  while (::poll(&greeting, 1, patience_ms) < 0 && errno == EINTR) {
  }
  const auto message = greeting.revents ? receive_message(launched.control.number()) : std::nullopt;
  Greeting first{};
  if (message && message->bytes.size() >= sizeof first) {
    std::memcpy(&first, message->bytes.data(), sizeof first);
    launched.renderer.assign(message->bytes.begin() + sizeof first, message->bytes.end());
  }
  if (!first.ready) {
    const std::string why = launched.renderer;
    end(launched);
    return {.why_not = why.empty() ? words_from(words.ours) : why};
  }
  launched.layers = first.layers;
  return {.launched = std::move(launched)};
}

}  // namespace

Launched launch(const Isolation& isolation, const fs::path& submissions) {
  if (isolation.namespaces == Isolation::Namespaces::where_allowed) {
    // A container may refuse a new /proc alone.
    for (const Proc proc : {Proc::mounted, Proc::absent}) {
      Attempt made = attempt(in_namespaces(isolation, submissions, proc));
      if (made.launched) return std::move(*made.launched);
    }
  }
  Attempt made = attempt(serving(isolation, false));
  if (made.launched) return std::move(*made.launched);
  throw MachineError("no process to draw in could be started" +
                     (made.why_not.empty() ? std::string() : ": " + made.why_not));
}

void end(Launched& launched) {
  if (launched.process < 0) return;
  launched.control.close();
  ::kill(launched.process, SIGKILL);
  while (::waitpid(launched.process, nullptr, 0) < 0 && errno == EINTR) {
  }
  launched.process = -1;
}

}  // namespace shadowlab::lab
