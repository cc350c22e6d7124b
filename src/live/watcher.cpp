#include "live/watcher.h"

#include <sys/stat.h>
#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_gettime is POSIX

#include <fstream>
#include <iterator>
#include <string>

namespace shadowlab::live {
namespace {

constexpr std::int64_t second = 1'000'000'000;
// The system's clock of files moves in ticks: of two writes within one, the second leaves the time
// as it was. A tick is at most 10 ms; some file systems keep 2 seconds at best.
constexpr std::int64_t tick = 20'000'000;
constexpr int most_restless = 3;

std::int64_t nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * second + time.tv_nsec;
}

}  // namespace

Watcher::Stamp Watcher::look(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return {true, status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
          nanoseconds(status.st_mtim)};
}

bool Watcher::may_change_unseen(const Stamp& stamp) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const bool whole_seconds = stamp.modified % second == 0;
  return nanoseconds(now) - stamp.modified < (whole_seconds ? 2 * second : tick);
}

std::size_t Watcher::hash_of(const std::filesystem::path& file, const Stamp& stamp) {
  if (!stamp.exists) return 0;
  std::ifstream stream(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  return std::hash<std::string>{}(text) | 1;  // never that of a missing file
}

void Watcher::watch(const std::filesystem::path& file) {
  notices_.listen_to(file);
  if (files_.contains(file)) return;
  const Stamp stamp = look(file);
  files_.emplace(file, File{stamp, hash_of(file, stamp), stamp});
}

void Watcher::keep(const std::set<std::filesystem::path>& files) {
  std::erase_if(files_, [&](const auto& watched) { return !files.contains(watched.first); });
}

bool Watcher::changed() {
  bool any = false;
  const auto completed = notices_.completed();
  for (auto& [path, file] : files_) {
    const Stamp now = look(path);
    const bool whole = completed.contains(path);
    const bool rests = whole || now == file.seen;
    file.seen = now;
    if (now == file.told && !whole && !(now.exists && may_change_unseen(now))) {
      file.restless = 0;
      continue;
    }
    if (!rests && ++file.restless <= most_restless) continue;
    file.restless = 0;
    const std::size_t contents = hash_of(path, now);
    // What the hash is of may be newer than `now`; the next look then sees another stamp.
    file.told = now;
    if (contents == file.contents) continue;
    file.contents = contents;
    any = true;
  }
  return any;
}

}  // namespace shadowlab::live
