#include "lab/zygote.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <optional>
#include <system_error>

#include "core/error.h"
#include "core/version.h"
#include "lab/channel.h"
#include "lab/filled_heap.h"
#include "lab/lock.h"
#include "lab/wire.h"

namespace shadowlab::lab {
namespace {

using Clock = std::chrono::steady_clock;

template <typename T>
std::vector<std::uint8_t> message_with(const T& record, const std::string& text) {
  std::vector<std::uint8_t> bytes(sizeof record + text.size());
  std::memcpy(bytes.data(), &record, sizeof record);
  std::memcpy(bytes.data() + sizeof record, text.data(), text.size());
  return bytes;
}

// The child has the channel as descriptor 3, and 0, 1, 2; no others.
void take_descriptors(const Message& order) {
  const int nowhere = ::open("/dev/null", O_RDONLY);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(order.descriptors[1].number(), STDOUT_FILENO);
  ::dup2(order.descriptors[2].number(), STDERR_FILENO);
  // Those above are copies, so nothing is lost where the channel's number is 3 already.
  ::dup2(order.descriptors[0].number(), control_descriptor);
  ::close_range(control_descriptor + 1, ~0U, 0);
}

[[noreturn]] void live(gl::Graphics& graphics, const Message& message, const Layers& expected,
                       const SystemCallFilter& filter, const Life& life) {
  Order order{};
  std::memcpy(&order, message.bytes.data(), sizeof order);
  const std::string folder(message.bytes.begin() + sizeof order, message.bytes.end());
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  take_descriptors(message);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  end_when_out_of_memory();
  int code = 0;
  try {
    if (::chdir(folder.c_str()) != 0) throw MachineError("the recipe's folder is gone");
    Layers layers = lock_in({.seconds = order.seconds + grace_seconds,
                             .memory = static_cast<std::size_t>(order.memory),
                             .readable = {folder, home() / "scripts", home() / "shaders"}},
                            filter);
    layers.namespaces = expected.namespaces;
    if (layers != expected) throw MachineError("the locks do not hold");
    life(graphics, control_descriptor);
  } catch (const std::bad_alloc&) {
    code = out_of_memory;
  } catch (const std::exception& problem) {
    const std::string_view words = problem.what();
    (void)!::write(STDERR_FILENO, words.data(), words.size());
    code = 1;
  }
  ::_exit(code);
}

// What a child of this process can be held by: found out by a child.
Layers try_layers(const SystemCallFilter& filter) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const pid_t child = ::fork();
  if (child == 0) {
    const Layers layers = lock_in({.readable = {home() / "scripts"}}, filter);
    (void)!::write(to.number(), &layers, sizeof layers);
    ::_exit(0);
  }
  to.close();
  Layers layers;
  if (child < 0 || ::read(from.number(), &layers, sizeof layers) != sizeof layers) layers = {};
  ::waitpid(child, nullptr, 0);
  return layers;
}

struct Child {
  pid_t process;
  Descriptor word;  // for the word that it has ended; its other end's closing kills
  Clock::time_point deadline;
  bool timed_out = false;
};

class Zygote {
 public:
  Zygote(const ZygoteOptions& options, const Life& life) : life_(life) {
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    ::sigprocmask(SIG_BLOCK, &children, nullptr);
    graphics_.emplace(context::create(options.backend), options.width, options.height);
    warm_up(*graphics_, options.warm, options.warmth);
    layers_ = try_layers(filter_);
    layers_.namespaces = options.namespaces;
    ended_ = Descriptor(::signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
    filled_.emplace();
  }

  ~Zygote() {
    for (const Child& child : children_) ::kill(child.process, SIGKILL);
  }
  Zygote(const Zygote&) = delete;
  Zygote& operator=(const Zygote&) = delete;

  const Layers& layers() const { return layers_; }
  const std::string& renderer() const { return graphics_->context().renderer; }

  void serve() {
    while (wait()) {
      kill_the_late();
      bury_the_dead();
    }
  }

 private:
  // Until something happens; false when nobody gives orders any more.
  bool wait() {
    std::vector<pollfd> watched{{control_descriptor, POLLIN, 0}, {ended_.number(), POLLIN, 0}};
    auto next = Clock::time_point::max();
    for (const Child& child : children_) {
      watched.push_back({child.word.number(), 0, 0});
      if (!child.timed_out) next = std::min(next, child.deadline);
    }
    int patience = -1;
    if (next != Clock::time_point::max()) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
      patience = static_cast<int>(std::clamp<std::int64_t>(left, 0, 60'000));
    }
    if (::poll(watched.data(), watched.size(), patience) < 0) return errno == EINTR;
    for (std::size_t i = 2; i < watched.size(); ++i) {
      if (watched[i].revents & (POLLHUP | POLLERR)) ::kill(children_[i - 2].process, SIGKILL);
    }
    if (watched[0].revents == 0) return true;
    const auto message = receive_message(control_descriptor);
    if (!message) return false;
    if (message->bytes.size() > sizeof(Order) && message->descriptors.size() == 4) begin(*message);
    return true;
  }

  void begin(const Message& message) {
    Order order{};
    std::memcpy(&order, message.bytes.data(), sizeof order);
    const pid_t process = ::fork();
    if (process == 0) live(*graphics_, message, layers_, filter_, life_);
    if (process < 0) return;  // the word's end closes with the message, which says it
    const auto patience = std::chrono::duration<double>(order.seconds);
    children_.push_back({process,
                         Descriptor(::fcntl(message.descriptors[3].number(), F_DUPFD_CLOEXEC, 4)),
                         Clock::now() + std::chrono::duration_cast<Clock::duration>(patience)});
  }

  void kill_the_late() {
    for (Child& child : children_) {
      if (child.timed_out || Clock::now() < child.deadline) continue;
      child.timed_out = true;
      ::kill(child.process, SIGKILL);
    }
  }

  void bury_the_dead() {
    signalfd_siginfo ignored;
    while (::read(ended_.number(), &ignored, sizeof ignored) > 0) {
    }
    std::erase_if(children_, [](const Child& child) {
      int status = 0;
      rusage used{};
      if (::wait4(child.process, &status, WNOHANG, &used) != child.process) return false;
      const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
      };
      const Ended ended{status, child.timed_out, seconds(used.ru_utime) + seconds(used.ru_stime),
                        static_cast<std::uint64_t>(used.ru_maxrss) * 1024};
      send_message(child.word.number(),
                   {reinterpret_cast<const std::uint8_t*>(&ended), sizeof ended});
      return true;
    });
  }

  std::optional<gl::Graphics> graphics_;
  const Life& life_;
  const SystemCallFilter filter_;
  Layers layers_;
  Descriptor ended_;
  std::vector<Child> children_;
  std::optional<FilledHeap> filled_;  // once all is warm
};

void send_all(int channel, const wire::Bytes& bytes) {
  if (!write_all(channel, bytes)) ::_exit(1);  // nobody wants it any more
}

}  // namespace

void draw_for(gl::Graphics& warm, int channel) {
  std::array<std::uint8_t, wire::header_size> head{};
  if (!read_all(channel, head)) return;
  wire::Bytes body(wire::header_from(head).length);
  if (!read_all(channel, body)) return;
  const Job job = wire::job_from(body);
  std::optional<gl::Graphics> of_its_size;
  if (job.width != warm.width() || job.height != warm.height())
    of_its_size.emplace(context::create(warm.context().backend), job.width, job.height);
  draw(of_its_size ? *of_its_size : warm, job, [&](std::size_t shot, const Drawing& drawing) {
    send_all(channel, wire::message_of(shot, drawing));
  });
  send_all(channel, wire::done_message());
  ::_exit(0);
}

void serve(const ZygoteOptions& options, const Life& life) {
  std::optional<Zygote> zygote;
  try {
    zygote.emplace(options, life);
  } catch (const std::exception& problem) {
    send_message(control_descriptor, message_with(Greeting{0, {}}, problem.what()));
    return;
  }
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // its children cannot look into it
  // What it had to say on its standard error has been read by now.
  const Descriptor nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  ::dup2(nowhere.number(), STDERR_FILENO);
  if (send_message(control_descriptor,
                   message_with(Greeting{1, zygote->layers()}, zygote->renderer())))
    zygote->serve();
}

}  // namespace shadowlab::lab
