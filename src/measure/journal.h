// What was measured so far, on disk line by line, so that a measurement that is interrupted goes
// on.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "measure/record.h"

namespace shadowlab::measure {

/// A file of lines {"key": …, "value": …}, each written whole before the next is begun. A last line
/// that was cut off counts as not written.
class Journal {
 public:
  /// Opens or begins `file` for a measurement of `options`. Throws InputError where it holds one of
  /// other options, is no journal, or cannot be written.
  Journal(const std::filesystem::path& file, const Json& options);

  std::optional<Json> find(const std::string& key) const;
  /// Throws InputError where the disk is full.
  void write(const std::string& key, const Json& value);
  /// How many entries were there when it was opened.
  std::size_t found() const { return found_; }

 private:
  void read();

  std::filesystem::path file_;
  std::map<std::string, Json> entries_;
  std::ofstream out_;
  std::size_t found_ = 0;
};

}  // namespace shadowlab::measure
