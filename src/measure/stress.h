// The numerically hard cases, each as a row: what is exact, what the listing of a lecture gives,
// what shadowlab gives. The rows are those of files of facts (fact_file.h): what they say holds
// because the facts hold, which are tests too.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "measure/fact_file.h"
#include "measure/record.h"
#include "measure/sweep.h"

namespace shadowlab::measure {

struct StressRow {
  HardCase hard;
  std::string file;         ///< where its facts are
  std::vector<Note> naive;  ///< what its facts told
  std::vector<Note> ours;
  std::string failure;  ///< the expectation that failed, with its fact; empty where all hold

  bool passes() const { return failure.empty(); }
};

/// The rows of all files in `folder` whose number is one of `wanted` (all, where that is empty), by
/// number. Throws InputError for a number that no row has, and for two rows of one number.
std::vector<StressRow> stress(const std::filesystem::path& folder, std::span<const int> wanted,
                              const std::function<void(const Progress&)>& progress);

/// What a row tells of the listing, or of shadowlab: its words, joined.
std::string naive_words(const StressRow& row);
std::string our_words(const StressRow& row);

/// The first picture of each, relative to the folder that write_pictures wrote into; "" without
/// one.
struct RowPictures {
  std::string naive, ours;
};
RowPictures write_pictures(const StressRow& row, const std::filesystem::path& folder);

/// A row as stress.json has it.
Json record_of(const StressRow& row, const RowPictures& pictures);

/// stress.csv and stress.html of such records; the page's pictures are read from `folder`.
std::string stress_csv(const Json& rows);
std::string stress_page(const Json& rows, const std::filesystem::path& folder);

}  // namespace shadowlab::measure
