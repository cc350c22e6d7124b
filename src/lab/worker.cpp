#include "lab/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <optional>
#include <random>

#include "core/error.h"
#include "lab/channel.h"
#include "lab/launch.h"
#include "lab/reception.h"
#include "lab/verdict.h"
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

// The recipe and what belongs to it.
std::optional<std::string> copy_all(const Job& job, const fs::path& folder) {
  if (auto problem = copy_recipe(job.recipe, folder / job.recipe.filename())) return problem;
  for (const fs::path& file : job.beside) {
    fs::create_directories((folder / file).parent_path());
    if (auto problem = copy_recipe(job.recipe.parent_path() / file, folder / file)) return problem;
  }
  return std::nullopt;
}

// Ends with the last who uses it.
struct Running {
  explicit Running(Launched started) : launched(std::move(started)) {}
  ~Running() { end(launched); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  Launched launched;
};

}  // namespace

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
    if (auto problem = copy_all(given, folder.path())) {
      outcome.verdict = Verdict::recipe_error;
      outcome.sentence = std::move(*problem);
    } else {
      Reception came(job, isolation_, each);
      run(came, job, folder.path());
      Ruling ruling = judge(came, isolation_);
      outcome.verdict = ruling.verdict;
      outcome.sentence = std::move(ruling.sentence);
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
    const Order order{isolation_.seconds, isolation_.memory};
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
