#include "lab/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <mutex>
#include <optional>
#include <random>

#include "core/error.h"
#include "lab/channel.h"
#include "lab/launch.h"
#include "lab/lock.h"
#include "lab/reception.h"
#include "lab/wire.h"
#include "lab/zygote.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t largest_source = std::size_t{64} << 20;

// A folder that goes with its owner.
class Folder {
 public:
  explicit Folder(fs::path path) : path_(std::move(path)) {}
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code none;
    fs::permissions(path_, fs::perms::owner_all, none);  // to list it
    fs::remove_all(path_, none);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Others may enter it who know a name in it, and nobody may list it.
fs::path make_submissions_folder() {
  std::string name = (fs::temp_directory_path() / "shadowlab-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw MachineError(fmt::format("a folder for submissions cannot be made in {} ({})",
                                   fs::temp_directory_path().string(), std::strerror(errno)));
  ::chmod(name.c_str(), 0311);
  return name;
}

fs::path make_folder_of_one(const fs::path& submissions) {
  std::random_device random;
  fs::path folder =
      submissions / fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
  if (::mkdir(folder.c_str(), 0755) != 0)
    throw MachineError(fmt::format("a folder for a submission cannot be made in {} ({})",
                                   submissions.string(), std::strerror(errno)));
  return folder;
}

// Copies the recipe, and nothing that a link or a device of its name leads to. The sentence says
// why it cannot be one.
std::optional<std::string> copy_recipe(const fs::path& from, const fs::path& to) {
  const std::string name = from.string();
  const Descriptor in(::open(from.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat state {};
  if (!in.is_open() && errno == ELOOP)
    return name + " is a link to another file; hand in the file itself";
  if (!in.is_open() || ::fstat(in.number(), &state) != 0)
    return fmt::format("{} cannot be read ({})", name, std::strerror(errno));
  if (!S_ISREG(state.st_mode)) return name + " is not a plain file; hand in a Lua file";
  if (static_cast<std::size_t>(state.st_size) > largest_source)
    return fmt::format("{} has {} MiB, too large for a recipe", name, state.st_size >> 20);
  const Descriptor out(::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  std::vector<char> block(std::size_t{1} << 16);
  for (ssize_t got = 0; (got = ::read(in.number(), block.data(), block.size())) > 0;) {
    if (::write(out.number(), block.data(), static_cast<std::size_t>(got)) != got)
      throw MachineError(
          fmt::format("{} cannot be written ({})", to.string(), std::strerror(errno)));
  }
  return std::nullopt;
}

// For whoever gets the submission: it is none that a recipe brings about by mistake.
constexpr const char* to_whom = "; no recipe does that by mistake: show it to your instructor";

std::string time_sentence(double seconds) {
  return fmt::format(
      "the submission was still drawing after {:g} s and was stopped; look for a loop that does "
      "not "
      "end, in the script or in a shader",
      seconds);
}

std::string memory_sentence(std::size_t bytes) {
  return fmt::format(
      "the submission needed more than {} MiB of memory and was stopped; look for a table, a text "
      "or "
      "a texture that grows without end",
      bytes >> 20);
}

struct Judgement {
  Verdict verdict;
  std::string sentence;
};

// What a child's end by a signal means.
Judgement of_signal(int signal, const Isolation& isolation) {
  switch (signal) {
    case SIGXCPU:
      return {Verdict::timed_out, time_sentence(isolation.seconds)};
    case SIGSYS:
      return {Verdict::forbidden,
              std::string("the submission's process asked the system for what drawing never needs, "
                          "and was stopped") +
                  to_whom};
    case SIGKILL:  // not by us: the system's own way out of a lack of memory
      return {Verdict::out_of_memory,
              "this machine ran out of memory and stopped the submission; look for a table, a text "
              "or a texture that grows without end"};
    default:
      return {Verdict::crashed, fmt::format("the submission's process broke down (signal {}, {}){}",
                                            signal, ::strsignal(signal), to_whom)};
  }
}

Judgement judge(const Reception& came, const Isolation& isolation) {
  if (came.flooded)
    return {Verdict::flooded,
            std::string("the submission sent more than anybody reads, and was stopped") + to_whom};
  if (came.garbled)
    return {Verdict::garbled, fmt::format("the submission's process sent what is no drawing ({}){}",
                                          *came.garbled, to_whom)};
  if (came.lost)
    return {Verdict::crashed,
            std::string("the submission's process ended together with the one that started it") +
                to_whom};
  if (!came.ended || came.ended->timed_out)
    return {Verdict::timed_out, time_sentence(isolation.seconds)};
  const int status = came.ended->status;
  if (WIFSIGNALED(status)) return of_signal(WTERMSIG(status), isolation);
  if (WEXITSTATUS(status) == out_of_memory)
    return {Verdict::out_of_memory, memory_sentence(isolation.memory)};
  if (WEXITSTATUS(status) != 0)
    return {Verdict::crashed, fmt::format("the submission's process gave up ({}){}",
                                          came.err.empty() ? "without a word" : came.err, to_whom)};
  if (!came.done)
    return {Verdict::garbled,
            std::string("the submission's process ended before all was drawn") + to_whom};
  if (came.first_error) return {Verdict::recipe_error, *came.first_error};
  return {Verdict::finished, ""};
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::finished:
      return "finished";
    case Verdict::recipe_error:
      return "recipe error";
    case Verdict::timed_out:
      return "timed out";
    case Verdict::out_of_memory:
      return "out of memory";
    case Verdict::crashed:
      return "crashed";
    case Verdict::forbidden:
      return "forbidden";
    case Verdict::flooded:
      return "flooded";
    case Verdict::garbled:
      return "garbled";
  }
  return "";
}

// Ends with the last who uses it.
struct Running {
  explicit Running(Launched started) : launched(std::move(started)) {}
  ~Running() { end(launched); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  Launched launched;
};

class Worker::Impl {
 public:
  explicit Impl(Isolation isolation)
      : isolation_(std::move(isolation)),
        submissions_(make_submissions_folder()),
        running_(start()) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Outcome draw(const Job& given, const Reception::Each& each) {
    const auto begin = Clock::now();
    Outcome outcome;
    const Folder folder(make_folder_of_one(submissions_.path()));
    Job job = given;
    job.recipe = given.recipe.filename();
    if (auto problem = copy_recipe(given.recipe, folder.path() / job.recipe)) {
      outcome.verdict = Verdict::recipe_error;
      outcome.sentence = std::move(*problem);
    } else {
      Reception came(job, isolation_, each);
      run(came, job, folder.path());
      Judgement judgement = judge(came, isolation_);
      outcome.verdict = judgement.verdict;
      outcome.sentence = std::move(judgement.sentence);
      outcome.out = std::move(came.out);
      outcome.err = std::move(came.err);
      if (came.ended) {
        outcome.processor_seconds = came.ended->processor_seconds;
        outcome.peak_memory = static_cast<std::size_t>(came.ended->peak_memory);
      }
    }
    outcome.layers = running()->launched.layers;
    outcome.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return outcome;
  }

  std::shared_ptr<Running> running() const {
    const std::lock_guard lock(replacing_);
    return running_;
  }

 private:
  // A worker may be lost through no fault of the job: by the system's way out of a lack of memory,
  // or by another job's. So the job begins again in a new one, but not for ever.
  void run(Reception& came, const Job& job, const fs::path& folder) {
    constexpr int attempts = 3;
    for (int i = 0; i < attempts; ++i) {
      const std::shared_ptr<Running> worker = running();
      came.lost = !order(*worker, came, job, folder);
      if (came.lost || came.unanswered) replace(worker);
      if (!came.lost) return;
    }
  }

  // False where the worker was lost.
  bool order(const Running& worker, Reception& came, const Job& job, const fs::path& folder) {
    Ends channel = make_stream(), out = make_pipe(), err = make_pipe(), word = make_messages();
    const Order order{isolation_.seconds, isolation_.seconds, isolation_.memory};
    const std::string path = folder.string();
    std::vector<std::uint8_t> bytes(sizeof order + path.size());
    std::memcpy(bytes.data(), &order, sizeof order);
    std::memcpy(bytes.data() + sizeof order, path.data(), path.size());
    const std::array<int, 4> theirs{channel.theirs.number(), out.theirs.number(),
                                    err.theirs.number(), word.theirs.number()};
    if (!send_message(worker.launched.control.number(), bytes, theirs)) return false;
    for (Ends* ends : {&channel, &out, &err, &word}) ends->theirs.close();
    Lines lines{std::move(channel.ours), std::move(out.ours), std::move(err.ours),
                std::move(word.ours)};
    came.receive(lines, wire::message_of(job));
    return !came.lost;
  }

  // The first who finds it lost replaces it for all.
  void replace(const std::shared_ptr<Running>& worker) {
    const std::lock_guard lock(replacing_);
    if (running_ == worker) running_ = start();
  }

  std::shared_ptr<Running> start() const {
    return std::make_shared<Running>(launch(isolation_, submissions_.path()));
  }

  Isolation isolation_;
  Folder submissions_;
  std::shared_ptr<Running> running_;
  mutable std::mutex replacing_;
};

Worker::Worker(Isolation isolation) : impl_(std::make_unique<Impl>(std::move(isolation))) {}
Worker::~Worker() = default;

Outcome Worker::draw(const Job& job) {
  std::vector<Drawing> drawings;
  Outcome outcome =
      draw(job, [&](std::size_t, Drawing drawing) { drawings.push_back(std::move(drawing)); });
  outcome.drawings = std::move(drawings);
  return outcome;
}

Outcome Worker::draw(const Job& job, const std::function<void(std::size_t, Drawing)>& each) {
  return impl_->draw(job, each);
}

Layers Worker::layers() const { return impl_->running()->launched.layers; }
std::string Worker::renderer() const { return impl_->running()->launched.renderer; }

Outcome draw_isolated(const Job& job, const Isolation& isolation) {
  return Worker(isolation).draw(job);
}

}  // namespace shadowlab::lab
