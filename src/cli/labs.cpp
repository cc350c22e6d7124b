#include "cli/labs.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/files.h"
#include "core/error.h"
#include "core/near_names.h"
#include "core/version.h"
#include "lab/formats.h"
#include "lab/report.h"

namespace shadowlab::cli {

namespace fs = std::filesystem;

std::vector<fs::path> all_labs() {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(home() / "labs", none)) {
    if (fs::exists(entry.path() / "lab.lua", none)) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

fs::path find_lab(const std::string& given) {
  std::error_code none;
  if (fs::is_directory(given, none)) return given;
  std::vector<std::string> names;
  for (const fs::path& lab : all_labs()) {
    if (lab.filename() == given) return lab;
    names.push_back(lab.filename().string());
  }
  const std::vector<std::string_view> near(names.begin(), names.end());
  throw InputError(
      fmt::format("there is no lab {}: a lab is a folder with a lab.lua, or a name that shadowlab "
                  "list labs prints{}",
                  given, did_you_mean(given, near)));
}

void print_result(const lab::Result& result, std::size_t widest_name) {
  std::string why = result.error;
  for (const lab::CaseResult& one : result.cases) {
    if (!why.empty()) break;
    if (one.status == lab::Status::passed) continue;
    why = fmt::format("{}: {}", one.name,
                      one.says.size() > 1 ? one.says[1]
                      : one.says.empty()  ? ""
                                          : one.says[0]);
  }
  fmt::print("{:<{}}  {:>5.4g} / {:.4g}{}{}\n", result.submission, widest_name, result.score,
             result.most, why.empty() ? "" : "  ", why);
}

void write_class(const fs::path& out, std::span<const lab::Result> results,
                 lab::Language language) {
  write_text(out / "index.html", lab::class_page(results, language));
  write_text(out / "scores.csv", lab::scores_csv(results));
}

}  // namespace shadowlab::cli
