// Which calls to the system the process that draws a submission may make.
#pragma once

#include <linux/filter.h>

#include <vector>

namespace shadowlab::lab {

/// The list of them as the kernel takes it. Made once, for all processes that it is to hold: making
/// it takes longer than anything else that locks a process in.
class SystemCallFilter {
 public:
  SystemCallFilter();

  /// From now on the calling thread and all that it starts may make no others: a call that drawing
  /// could try in good faith fails, any other ends the process by SIGSYS. False where this kernel
  /// has no such filters. New privileges must have been given up.
  bool hold() const;

 private:
  std::vector<sock_filter> program_;  // none where it cannot be made
};

}  // namespace shadowlab::lab
