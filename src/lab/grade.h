// One submission against a lab: drawn, compared, scored, explained.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "lab/diagnose.h"
#include "lab/manifest.h"
#include "lab/reference.h"
#include "lab/results.h"
#include "lab/sentences.h"
#include "lab/submissions.h"

namespace shadowlab::lab {

/// How the drawing of a submission ended.
struct Drawn {
  std::string verdict = "finished";
  std::string sentence;  ///< what happened, for the student; empty for "finished"
  std::string layers;    ///< of isolation, that held
};

/// Draws a job of a submission: each drawing as soon as it is there. From any thread.
using DrawSubmission =
    std::function<Drawn(const Job&, const std::function<void(std::size_t shot, Drawing)>&)>;

/// Whether what students are not to see is in their reports.
enum class Hidden { left_out, shown };

struct GradeOptions {
  Language language = Language::english;
  Hidden hidden = Hidden::left_out;
  std::filesystem::path pictures;  ///< the folder to write pictures into; none where empty
  /// Told of the result so far after each case: a grader that is stopped keeps partial marks.
  std::function<void(const Result&)> after_case;
  std::string program = "shadowlab";
};

Result grade(const Lab& lab, const Reference& reference, const Submission& submission,
             const DrawSubmission& draw, const GradeOptions& options);

/// The digest of what was handed in, as Result::digest has it.
std::uint64_t digest_of(const Submission& submission);

/// What pictures of the reference are called in the folder that all reports share: of case
/// `index` (0-based), and of its pass.
std::string expected_name(std::size_t index);
std::string expected_pass_name(std::size_t index, std::size_t pass, const char* buffer);
/// Writes them; hidden cases only where they are shown.
void write_expected(const Lab& lab, const Reference& reference, const std::filesystem::path& folder,
                    Hidden hidden);

}  // namespace shadowlab::lab
