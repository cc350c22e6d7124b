// Files read and written in one go.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace shadowlab::image {

/// Throws InputError when the file is missing, a folder, or cannot be read.
std::vector<std::uint8_t> read_whole(const std::filesystem::path& file);

/// Writes the parts one after the other into a temporary file beside `file` and renames it to
/// `file`, so that nobody ever reads half of one. A link is followed; a device or a pipe is written
/// to as it is. Throws InputError when the folder is missing or cannot be written, or the disk is
/// full.
void write_whole(const std::filesystem::path& file,
                 std::span<const std::span<const std::uint8_t>> parts);

}  // namespace shadowlab::image
