#include "image/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/error.h"

namespace shadowlab::image {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void cannot_write(const fs::path& file, int error) {
  throw InputError("Cannot write " + file.string() + " (" + reason(error) +
                   "); choose a place that can be written.");
}

class OpenFile {
 public:
  OpenFile(const fs::path& file, int flags) : number_(::open(file.c_str(), flags, 0666)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }

  bool is_open() const { return number_ >= 0; }

  /// 0, or errno. Closing is part of it: some file systems report a full disk only then.
  int write_and_close(std::span<const std::span<const std::uint8_t>> parts) {
    for (std::span<const std::uint8_t> rest : parts) {
      while (!rest.empty()) {
        const ssize_t written = ::write(number_, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        rest = rest.subspan(static_cast<std::size_t>(written));
      }
    }
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0 ? 0 : errno;
  }

 private:
  int number_;
};

// No two writers of one folder have the same name, in this process or in another.
fs::path temporary_beside(const fs::path& file) {
  static std::atomic<unsigned> count = 0;
  return file.parent_path() /
         fmt::format(".{}.{}-{}.tmp", file.filename().string(), ::getpid(), count++);
}

}  // namespace

std::vector<std::uint8_t> read_whole(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none)) throw InputError("There is no file " + file.string() + ".");
  if (fs::is_directory(file, none)) {
    throw InputError(file.string() + " is a folder, and a file is needed.");
  }
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  const auto size = fs::file_size(file, none);
  if (!none) bytes.reserve(size);
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    bytes.insert(bytes.end(), block, block + in.gcount());
  }
  if (!in.eof()) throw InputError("Cannot read " + file.string() + " (" + reason(errno) + ").");
  return bytes;
}

void write_whole(const fs::path& file, std::span<const std::span<const std::uint8_t>> parts) {
  std::error_code none;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, none)) {
    throw InputError("Cannot write " + file.string() + ": there is no folder " + folder.string() +
                     "; make it first.");
  }
  const auto status = fs::status(file, none);
  if (fs::is_directory(status)) {
    throw InputError("Cannot write " + file.string() + ": it is a folder.");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    OpenFile device(file, O_WRONLY | O_CLOEXEC);
    const int error = device.is_open() ? device.write_and_close(parts) : errno;
    if (error) cannot_write(file, error);
    return;
  }
  const fs::path target = fs::exists(status) ? fs::canonical(file) : file;
  const fs::path temporary = temporary_beside(target);
  OpenFile out(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC);
  if (!out.is_open()) cannot_write(file, errno);
  int error = out.write_and_close(parts);
  if (!error && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error) {
    ::unlink(temporary.c_str());
    cannot_write(file, error);
  }
}

}  // namespace shadowlab::image
