// Labs as the command line names them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/results.h"
#include "lab/run.h"

namespace shadowlab::cli {

/// The lab's folder: as given, or NAME for labs/NAME. Throws InputError with near names.
std::filesystem::path find_lab(const std::string& given);

/// The folders of labs/ that are labs, sorted.
std::vector<std::filesystem::path> all_labs();

/// A line of a result for a terminal: NAME, points, what went wrong.
void print_result(const lab::Result& result, std::size_t widest_name);

/// What a run leaves at its end beside the submissions' own folders: index.html, scores.csv,
/// results.json.
void write_class(const std::filesystem::path& out, std::span<const lab::Result> results,
                 lab::Language language);

}  // namespace shadowlab::cli
