// Texts to and from files: internal to this floor.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace shadowlab::lab {

/// The whole file; empty where it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// Whole or not at all, also when the process is killed in between. Throws InputError.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace shadowlab::lab
