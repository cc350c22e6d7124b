// Results as pages for people: no script from elsewhere, no network, all by keyboard.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lab/grade.h"
#include "lab/results.h"
#include "lab/sentences.h"

namespace shadowlab::lab {

/// One submission's page, for OUT/submissions/NAME/report.html: it shows pictures of its own folder
/// and of OUT/expected/.
std::string report_page(const Result& result, Language language, Hidden hidden);

/// The class's, for OUT/index.html: how the scores lie, which cases and mistakes are most frequent,
/// which submissions make the same calls of GL.
std::string class_page(std::span<const Result> results, Language language);

/// NAME;score;max;verdict, a line a submission, for a spreadsheet.
std::string scores_csv(std::span<const Result> results);

/// Text between tags or in an attribute.
std::string in_html(std::string_view text);

}  // namespace shadowlab::lab
