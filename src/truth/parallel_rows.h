// Rows shared out over threads. Which thread takes a row never shows in a result, as long as `row`
// writes only what belongs to its row.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace shadowlab::truth {

/// Calls row(y) once for each y in [0, rows), from `threads` threads (0: as many as the machine
/// has). The first exception is thrown again here, after all threads have stopped.
template <typename Row>
void parallel_rows(int rows, int threads, Row&& row) {
  if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    try {
      for (int y = next++; y < rows; y = next++) row(y);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = rows;
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < std::min(threads, rows); ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace shadowlab::truth
