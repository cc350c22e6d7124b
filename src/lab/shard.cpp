// Which submissions are ours, and the folders of several put together.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <map>

#include "core/error.h"
#include "lab/run.h"
#include "lab/text_file.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

std::optional<int> number(const char* text) {
  if (!text) return std::nullopt;
  const std::string_view given(text);
  int value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  if (error != std::errc() || end != given.data() + given.size()) return std::nullopt;
  return value;
}

struct Speaker {
  const char *index, *count, *first;  ///< variables; `first` says what the index counts from
};
constexpr std::array speakers{
    Speaker{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN"},
    Speaker{"GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS", nullptr},
    Speaker{"JOB_COMPLETION_INDEX", "JOB_COMPLETIONS", nullptr},
};

void expect_one_run(const RunIdentity& a, const RunIdentity& b, const fs::path& folder) {
  if (a.lab == b.lab && a.digest == b.digest && a.seed == b.seed) return;
  throw InputError(
      fmt::format("{} holds results of another lab or seed; only shards of one run can be merged",
                  folder.string()));
}

}  // namespace

Shard shard_from(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = number(text.substr(0, slash).c_str()),
               count = number(text.substr(slash + 1).c_str());
    if (index && count && *index >= 1 && *index <= *count) return {*index - 1, *count};
  }
  throw InputError(
      fmt::format("--shard takes I/N, as in 2/8 for the second of eight; \"{}\" given", text));
}

std::optional<Shard> shard_from_environment() {
  for (const Speaker& speaker : speakers) {
    if (!std::getenv(speaker.index) || !std::getenv(speaker.count)) continue;
    const auto index = number(std::getenv(speaker.index)),
               count = number(std::getenv(speaker.count));
    const int first = speaker.first ? number(std::getenv(speaker.first)).value_or(0) : 0;
    if (!index || !count || *index - first < 0 || *index - first >= *count) {
      throw InputError(fmt::format("{}={} and {}={} name no shard", speaker.index,
                                   std::getenv(speaker.index), speaker.count,
                                   std::getenv(speaker.count)));
    }
    return Shard{*index - first, *count};
  }
  return std::nullopt;
}

std::vector<Result> merge(std::span<const fs::path> folders, const fs::path& out) {
  std::optional<RunIdentity> identity;
  std::map<std::string, std::pair<Result, fs::path>> all;
  for (const fs::path& folder : folders) {
    RunIdentity one = identity_of(folder);
    if (identity) expect_one_run(*identity, one, folder);
    if (!identity) identity = one;
    for (Result& result : results_in(folder)) {
      const auto known = all.find(result.submission);
      if (known == all.end()) {
        const fs::path from = folder / "submissions" / result.submission;
        std::string name = result.submission;
        all.emplace(std::move(name), std::pair{std::move(result), from});
      } else if (known->second.first.digest != result.digest ||
                 known->second.first.score != result.score) {
        throw InputError(fmt::format("{} and {} differ about the submission {}; grade it anew",
                                     known->second.second.parent_path().parent_path().string(),
                                     folder.string(), result.submission));
      }
    }
  }
  identity->shard = {};
  fs::create_directories(out / "submissions");
  write_identity(out, *identity);
  for (const fs::path& folder : folders) {
    std::error_code none;
    if (fs::is_directory(folder / "expected", none)) {
      fs::copy(folder / "expected", out / "expected",
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    }
  }
  std::vector<Result> results;
  for (auto& [name, found] : all) {
    const fs::path to = out / "submissions" / name;
    std::error_code none;
    if (!fs::equivalent(found.second, to, none))
      fs::copy(found.second, to,
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    results.push_back(std::move(found.first));
  }
  return results;
}

}  // namespace shadowlab::lab
