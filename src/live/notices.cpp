#include "live/notices.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstring>

namespace shadowlab::live {

Notices::Notices() : queue_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

Notices::~Notices() {
  if (queue_ >= 0) ::close(queue_);
}

void Notices::listen_to(const std::filesystem::path& file) {
  if (queue_ < 0) return;
  const std::filesystem::path folder = file.parent_path();
  const char* const name = folder.empty() ? "." : folder.c_str();
  // Of a folder that is listened to it gives the number again.
  const int number = ::inotify_add_watch(queue_, name, IN_CLOSE_WRITE | IN_MOVED_TO | IN_ONLYDIR);
  if (number >= 0) folders_[number].insert(folder);
}

std::set<std::filesystem::path> Notices::completed() {
  std::set<std::filesystem::path> files;
  alignas(inotify_event) std::array<char, 16384> bytes;
  for (ssize_t length = 0; (length = ::read(queue_, bytes.data(), bytes.size())) > 0;) {
    for (std::size_t at = 0; at < static_cast<std::size_t>(length);) {
      inotify_event event;
      std::memcpy(&event, bytes.data() + at, sizeof event);
      if (event.mask & IN_IGNORED) folders_.erase(event.wd);  // the folder is gone
      const auto folder = folders_.find(event.wd);
      if (event.len > 0 && folder != folders_.end()) {
        for (const auto& name : folder->second)
          files.insert(name / (bytes.data() + at + sizeof event));
      }
      at += sizeof event + event.len;
    }
  }
  return files;
}

}  // namespace shadowlab::live
