// A film of the recipe's picture, by ffmpeg where it is installed.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "image/image.h"

namespace shadowlab::live {

class Film {
 public:
  static constexpr int frames_per_second = 30;

  /// Begins a film of that size; GIF where the file's name ends so. Throws MachineError where
  /// ffmpeg is not installed.
  Film(std::filesystem::path file, int width, int height);

  /// The next frame, of the film's size. Whether it was taken: ffmpeg may have ended.
  bool add(const image::Image& picture);
  /// Ends it. Throws MachineError where ffmpeg could not write it.
  void finish();
  const std::filesystem::path& file() const { return file_; }
  int frames() const { return frames_; }

 private:
  struct Close {
    void operator()(std::FILE* pipe) const;
  };
  std::filesystem::path file_;
  std::unique_ptr<std::FILE, Close> pipe_;
  int frames_ = 0;
};

/// NAME.ending beside us, or NAME_2.ending and so on where that is taken.
std::filesystem::path unused_file(const std::string& name, const std::string& ending);

}  // namespace shadowlab::live
