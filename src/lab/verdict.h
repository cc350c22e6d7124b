// What came of a submission's process, in words: internal to this floor.
#pragma once

#include <string>

#include "lab/reception.h"

namespace shadowlab::lab {

struct Ruling {
  Verdict verdict;
  std::string sentence;  ///< what happened and what to do; empty for `finished`
};

Ruling judge(const Reception& came, const Isolation& isolation);

}  // namespace shadowlab::lab
