// Files that commands write: whole or not at all, also where Ctrl-C comes in between.
#pragma once

#include <csignal>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace shadowlab::cli {

/// While it lives, signals that end the program wait: a file that is being written is finished
/// first, so that no temporary one stays behind. GL's own threads take no signals (Mesa blocks
/// them).
class Undisturbed {
 public:
  Undisturbed();
  ~Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

 private:
  sigset_t before_;
};

/// Throws InputError where `file` could not be written later: its folder is missing or read-only,
/// or it is a folder itself. Asked before the work, so that the work is not lost.
void expect_writable(const std::filesystem::path& file);

/// Makes the folder and those above it. Throws InputError where it cannot.
void make_folder(const std::filesystem::path& folder);

/// As image::write_png, but opaque: what a window would show, whatever the frame's alpha is.
void write_picture(const std::filesystem::path& file, image::Image picture);
/// As image::write_npy.
template <class T>
void write_array(const std::filesystem::path& file, std::span<const std::size_t> shape,
                 const std::vector<T>& values) {
  const Undisturbed undisturbed;
  image::write_npy(file, shape, values);
}

enum class Existing { replace, refuse };

/// Writes a text through a temporary file beside it. Throws InputError where it cannot, or where
/// the file exists and that is refused.
void write_text(const std::filesystem::path& file, std::string_view text,
                Existing existing = Existing::replace);

}  // namespace shadowlab::cli
