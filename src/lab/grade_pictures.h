// The pictures of a report: internal to grading.
#pragma once

#include <filesystem>

#include "lab/grade.h"

namespace shadowlab::lab {

enum class Passes { left_out, written };

/// What case `index` of a submission looks like, where it differs, and its passes; their names go
/// into CaseResult::pictures.
void write_case_pictures(CaseResult& one, std::size_t index, const ReferenceCase& reference,
                         const Drawing& drawing, const std::filesystem::path& folder,
                         Passes passes);

}  // namespace shadowlab::lab
