// Whether the truth keeps the error bar that it states: held against shadows that are known in
// closed form (truth/closed_forms.h).
#pragma once

#include <string>
#include <vector>

#include "measure/record.h"

namespace shadowlab::measure {

struct BarCheck {
  std::string shadow;       ///< "a rectangle under a square light"
  double bar = 0;           ///< the standard error that was asked for
  std::size_t pixels = 0;   ///< in the penumbra
  double rmse = 0;          ///< of the truth against the closed form, there
  double within_one = 0;    ///< the share of them off by at most one bar
  double within_three = 0;  ///< by at most three
  double worst = 0;
  double samples = 0;  ///< a pixel of the picture, on average
  std::size_t unconverged = 0;
  /// The errors' mean square is at most the bar's.
  bool holds() const { return rmse <= bar && unconverged == 0; }
};

/// Traces a rectangle over a plane under a square light, and a disk under a disk light, of several
/// sizes and heights, at `size`² pixels.
std::vector<BarCheck> check_bar(double bar, int size);

Json record_of(const BarCheck& check);

}  // namespace shadowlab::measure
