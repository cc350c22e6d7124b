#include "live/film.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>

#include "core/error.h"

namespace shadowlab::live {
namespace {

bool installed(const char* program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code none;
    if (std::filesystem::is_regular_file(std::filesystem::path(folder) / program, none))
      return true;
  }
  return false;
}

// As a shell takes it whatever is in it.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

}  // namespace

void Film::Close::operator()(std::FILE* pipe) const { ::pclose(pipe); }

Film::Film(std::filesystem::path file, int width, int height) : file_(std::move(file)) {
  if (!installed("ffmpeg"))
    throw MachineError("A film needs ffmpeg: apt-get install ffmpeg brings it.");
  // A film's colours are halved in number across and down, so its sides are even.
  const std::string filter = file_.extension() == ".gif"
                                 ? "split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                 : "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p";
  const std::string command = fmt::format(
      "ffmpeg -y -loglevel error -f rawvideo -pixel_format rgba -video_size {}x{} -framerate {} "
      "-i - -vf {} {}",
      width, height, frames_per_second, quoted(filter), quoted("file:" + file_.string()));
  std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that ended is an error of `add`, not our end
  pipe_.reset(::popen(command.c_str(), "w"));
  if (!pipe_) throw MachineError("ffmpeg cannot be started.");
}

bool Film::add(const image::Image& picture) {
  if (!pipe_) return false;
  const std::size_t written = std::fwrite(picture.rgba.data(), 1, picture.rgba.size(), pipe_.get());
  ++frames_;
  return written == picture.rgba.size();
}

void Film::finish() {
  if (!pipe_) return;
  if (::pclose(pipe_.release()) != 0)
    throw MachineError("ffmpeg could not write " + file_.string() + ".");
}

std::filesystem::path unused_file(const std::string& name, const std::string& ending) {
  std::filesystem::path file = name + ending;
  for (int i = 2; std::filesystem::exists(file); ++i)
    file = fmt::format("{}_{}{}", name, i, ending);
  return file;
}

}  // namespace shadowlab::live
