// The line that says how far long work is, on a terminal alone.
#pragma once

#include <cstddef>
#include <string>

namespace shadowlab::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// "12 of 340: city/volumes_zfail; 3 min left". What is left is told from the steps done since
  /// the first call, once there are enough of them.
  void show(std::size_t done, std::size_t all, const std::string& what);
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
  double began_ = 0;
  std::size_t first_ = 0;
};

/// "40 s left", "3 min left"; "" where `seconds` says nothing.
std::string time_left(double seconds);

}  // namespace shadowlab::cli
