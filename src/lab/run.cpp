#include "lab/run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <semaphore>
#include <thread>
#include <utility>

#include "core/error.h"
#include "lab/report.h"
#include "lab/text_file.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// One process at a time works in a folder; the lock goes with the process, however it ends.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : file_(::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw InputError(fmt::format("cannot write into {}", folder.string()));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      ::close(file_);
      throw InputError(fmt::format("another shadowlab grade is at work in {}", folder.string()));
    }
  }
  ~FolderLock() { ::close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

// What a process that was killed left half written.
void remove_halves(const fs::path& folder) {
  std::error_code none;
  std::vector<fs::path> halves;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name.ends_with(".tmp")) halves.push_back(entry.path());
  }
  for (const fs::path& half : halves) fs::remove(half, none);
}

std::optional<Result> result_in(const fs::path& folder) {
  const std::string text = read_text(folder / "result.json");
  if (text.empty()) return std::nullopt;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded())
    throw InputError(fmt::format("{} is no JSON", (folder / "result.json").string()));
  return result_from(json);
}

void take_up(const fs::path& out, const RunIdentity& ours) {
  std::error_code none;
  if (!fs::exists(out / "run.json", none)) return write_identity(out, ours);
  const RunIdentity there = identity_of(out);
  const bool same = there.lab == ours.lab && there.digest == ours.digest &&
                    there.seed == ours.seed && there.shard.index == ours.shard.index &&
                    there.shard.count == ours.shard.count && there.language == ours.language &&
                    there.hidden == ours.hidden;
  if (same) return;
  throw InputError(fmt::format(
      "{} holds results of another run (lab, seed, shard or language differ); give another folder",
      out.string()));
}

// The results of some submissions, each written as soon as it is known.
class Run {
 public:
  Run(const Lab& lab, const Reference& reference, std::vector<Submission> ours,
      const DrawSubmission& draw, const RunOptions& options)
      : lab_(lab),
        reference_(reference),
        ours_(std::move(ours)),
        options_(options),
        jobs_(options.jobs),
        draw_([this, &draw](const Job& job, const auto& each) {
          Turn turn(jobs_);
          return draw(job, [&](std::size_t shot, Drawing drawing) {
            // While its process ends, and this is compared, the next is drawn.
            if (shot + 1 == job.shots.size()) turn.leave();
            each(shot, std::move(drawing));
          });
        }),
        results_(ours_.size()) {}

  std::vector<Result> all() {
    // One more than are drawn at once: while they are drawn it writes results, and reads what is
    // next.
    std::vector<std::thread> others;
    others.reserve(static_cast<std::size_t>(options_.jobs));
    for (int i = 0; i < options_.jobs; ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    if (failure_) std::rethrow_exception(failure_);
    return std::move(results_);
  }

 private:
  // One of the jobs, while it lives.
  class Turn {
   public:
    explicit Turn(std::counting_semaphore<>& jobs) : jobs_(&jobs) { jobs.acquire(); }
    ~Turn() { leave(); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    void leave() {
      if (auto* const jobs = std::exchange(jobs_, nullptr)) jobs->release();
    }

   private:
    std::counting_semaphore<>* jobs_;
  };

  void work() {
    try {
      for (std::size_t i; (i = next_++) < ours_.size() && !stopped_;) {
        results_[i] = one(ours_[i]);
        const std::lock_guard guard(mutex_);
        if (options_.progress) options_.progress(results_[i], ++done_, ours_.size());
      }
    } catch (...) {
      const std::lock_guard guard(mutex_);
      stopped_ = true;
      if (!failure_) failure_ = std::current_exception();
    }
  }

  Result one(const Submission& submission) const {
    const fs::path folder = options_.out / "submissions" / submission.name;
    if (auto there = result_in(folder); there && there->digest == digest_of(submission))
      return std::move(*there);
    std::error_code none;
    fs::remove_all(folder, none);
    fs::create_directories(folder);
    GradeOptions options = options_.grade;
    options.pictures = folder;
    Result result = grade(lab_, reference_, submission, draw_, options);
    write_text(folder / "report.html",
               report_page(result, options_.grade.language, options_.grade.hidden));
    write_text(folder / "result.json", text_of(to_json(result)) + "\n");
    return result;
  }

  const Lab& lab_;
  const Reference& reference_;
  const std::vector<Submission> ours_;
  const RunOptions& options_;
  std::counting_semaphore<> jobs_;
  const DrawSubmission draw_;  // no more at once than there are jobs
  std::vector<Result> results_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void write_identity(const fs::path& out, const RunIdentity& identity) {
  const Json json = {{"lab", identity.lab},
                     {"title", identity.title},
                     {"digest", fmt::format("{:016x}", identity.digest)},
                     {"seed", fmt::format("{}", identity.seed)},
                     {"shard", identity.shard.index + 1},
                     {"shards", identity.shard.count},
                     {"language", code_of(identity.language)},
                     {"hidden", identity.hidden == Hidden::shown ? "shown" : "left out"},
                     {"driver", identity.driver}};
  write_text(out / "run.json", text_of(json) + "\n");
}

RunIdentity identity_of(const fs::path& out) {
  const std::string text = read_text(out / "run.json");
  if (text.empty()) {
    throw InputError(
        fmt::format("{} holds no results of shadowlab grade: there is no run.json", out.string()));
  }
  try {
    const auto json = nlohmann::json::parse(text);
    RunIdentity identity;
    json.at("lab").get_to(identity.lab);
    json.at("title").get_to(identity.title);
    identity.digest = std::stoull(json.at("digest").get<std::string>(), nullptr, 16);
    identity.seed = std::stoull(json.at("seed").get<std::string>());
    identity.shard = {json.at("shard").get<int>() - 1, json.at("shards").get<int>()};
    identity.language = language_named(json.at("language").get<std::string>());
    identity.hidden = json.at("hidden") == "shown" ? Hidden::shown : Hidden::left_out;
    json.at("driver").get_to(identity.driver);
    return identity;
  } catch (const std::exception& problem) {
    throw InputError(fmt::format("{}/run.json is not what shadowlab grade writes", out.string()));
  }
}

std::vector<Result> results_in(const fs::path& out) {
  (void)identity_of(out);
  std::vector<Result> results;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(out / "submissions", none)) {
    if (auto result = result_in(entry.path())) results.push_back(std::move(*result));
  }
  std::sort(results.begin(), results.end(),
            [](const Result& a, const Result& b) { return a.submission < b.submission; });
  return results;
}

std::vector<Result> run(const Lab& lab, const Reference& reference,
                        std::span<const Submission> submissions, const DrawSubmission& draw,
                        const RunOptions& options) {
  std::vector<Submission> ours;
  for (std::size_t i = 0; i < submissions.size(); ++i) {
    if (i % static_cast<std::size_t>(options.shard.count) ==
        static_cast<std::size_t>(options.shard.index))
      ours.push_back(submissions[i]);
  }
  std::error_code error;
  fs::create_directories(options.out / "submissions", error);
  if (error) {
    throw InputError(
        fmt::format("cannot make the folder {}: {}", options.out.string(), error.message()));
  }
  const FolderLock lock(options.out);
  take_up(options.out, {lab.name, lab.title, lab.digest, lab.seed, options.shard,
                        options.grade.language, options.grade.hidden, reference.driver});
  remove_halves(options.out);
  remove_halves(options.out / "expected");
  write_expected(lab, reference, options.out / "expected", options.grade.hidden);
  return Run(lab, reference, std::move(ours), draw, options).all();
}

}  // namespace shadowlab::lab
