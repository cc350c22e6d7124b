// Why a picture is wrong: the first pass that departs, the mistake whose picture it is, the state
// that differs. Of use to a student, and never part of a mark.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "lab/compare.h"
#include "lab/manifest.h"
#include "lab/reference.h"
#include "lab/results.h"
#include "lab/sentences.h"
#include "lab/trace_state.h"

namespace shadowlab::lab {

/// What a case asks of a drawing, and how far it is from it: the first of colour, stencil and depth
/// that does not fit, or the last one that does.
struct CaseVerdict {
  std::string compared;  ///< "color", "stencil", "depth"
  std::string pass;      ///< of stencil and depth
  bool pass_missing = false;
  Judgement judgement;
  bool right() const { return !pass_missing && judgement.fits(); }
};
CaseVerdict verdict_of(const Case& a_case, const ReferenceCase& reference, const Drawing& drawing);

/// The mistake whose drawings are those of the submission, in as many as possible of the cases that
/// it gets wrong; an index into Lab::mistakes. `drawings` may hold fewer than there are cases.
std::optional<std::size_t> matching_mistake(const Lab& lab, const Reference& reference,
                                            const std::vector<Drawing>& drawings);

/// Where the drawing departs, and what state differs there.
struct Diagnosis {
  Finding finding;
  std::vector<std::string> says;
  /// What is set differently in that pass, the likeliest first; and the pass's index in the
  /// submission's drawing and in the reference's.
  std::vector<StateDifference> states;
  int yours = -1, theirs = -1;
};
Diagnosis diagnose(const ReferenceCase& reference, const Drawing& drawing, Language language);

/// "The pass "2. the shadow" draws with stencil function ALWAYS 1 … where the reference has …".
std::string say_state(const StateDifference& state, const std::string& pass, Language language);

}  // namespace shadowlab::lab
