// Zip archives, by libzip.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace shadowlab::lab {

/// A file of an archive that is written.
struct Packed {
  enum class Mode { plain, executable };
  std::string name;  ///< "labs/06/lab.lua"
  std::string bytes;
  Mode mode = Mode::plain;
};

/// Whole or not at all. Throws InputError where it cannot be written.
void write_zip(const std::filesystem::path& file, std::span<const Packed> files);

/// Unpacks into `folder`, which exists. What an archive from somebody else may not do: name a file
/// outside of the folder, hold links, or unpack to more than 4 GiB or 200,000 files. Throws
/// InputError for such an archive and for one that is broken.
void unzip(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace shadowlab::lab
