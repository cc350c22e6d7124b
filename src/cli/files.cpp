#include "cli/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/error.h"

namespace shadowlab::cli {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

Undisturbed::Undisturbed() {
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&ending, signal);
  pthread_sigmask(SIG_BLOCK, &ending, &before_);
}

Undisturbed::~Undisturbed() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void expect_writable(const fs::path& file) {
  std::error_code none;
  const fs::path folder = folder_of(file);
  const auto status = fs::status(file, none);
  if (fs::is_directory(status)) {
    throw InputError(fmt::format("cannot write {}: it is a folder", file.string()));
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) return;  // a device, a pipe
  if (!fs::is_directory(folder, none)) {
    throw InputError(fmt::format("cannot write {}: there is no folder {}; make it first",
                                 file.string(), folder.string()));
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError(fmt::format("cannot write {}: {} ({}); choose another place", file.string(),
                                 folder == "." ? "this folder" : folder.string(), reason(errno)));
  }
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    throw InputError(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  }
}

void write_picture(const fs::path& file, image::Image picture) {
  const Undisturbed undisturbed;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  image::write_png(file, picture);
}

void write_text(const fs::path& file, std::string_view text, Existing existing) {
  const Undisturbed undisturbed;
  const fs::path temporary = folder_of(file) / fmt::format(".{}.{}.tmp", file.filename().string(),
                                                           static_cast<long>(::getpid()));
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  int error = stream ? 0 : errno;
  if (!stream && error == 0) error = EIO;
  // A link fails where the name is taken, which a rename does not.
  if (!error && existing == Existing::refuse) {
    if (::link(temporary.c_str(), file.c_str()) != 0) error = errno;
  } else if (!error && ::rename(temporary.c_str(), file.c_str()) != 0) {
    error = errno;
  }
  if (error || existing == Existing::refuse) ::unlink(temporary.c_str());
  if (error == EEXIST) {
    throw InputError(fmt::format("{} exists already; choose another name", file.string()));
  }
  if (error) throw InputError(fmt::format("cannot write {}: {}", file.string(), reason(error)));
}

}  // namespace shadowlab::cli
