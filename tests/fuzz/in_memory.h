// Bytes as a file that is nowhere on a disk.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

namespace shadowlab::fuzz {

class FileOf {
 public:
  explicit FileOf(std::span<const std::uint8_t> bytes) : number_(::memfd_create("fuzzed", 0)) {
    if (::write(number_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
  ~FileOf() { ::close(number_); }
  FileOf(const FileOf&) = delete;
  FileOf& operator=(const FileOf&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

}  // namespace shadowlab::fuzz
