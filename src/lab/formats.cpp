#include "lab/formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "core/base64.h"
#include "core/error.h"
#include "lab/report.h"
#include "lab/text_file.h"

namespace shadowlab::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array format_names{"json", "gradescope", "prairielearn", "autolab", "junit"};
constexpr std::size_t prairielearn_limit = 1'000'000;  // bytes of results.json

// Scores that were summed show no 2.9999999999999996.
double rounded(double score) { return std::round(score * 1e6) / 1e6; }

std::string output_of(const CaseResult& one) {
  return fmt::format("{}", fmt::join(one.says, "\n"));
}

// XML is UTF-8 without control characters, whatever a submission's error says.
std::string in_xml(const std::string& text) {
  return in_html(nlohmann::json::parse(text_of(Json(text), -1)).get<std::string>());
}

}  // namespace

Format format_named(std::string_view name) {
  for (std::size_t i = 0; i < format_names.size(); ++i) {
    if (format_names[i] == name) return static_cast<Format>(i);
  }
  throw InputError(
      fmt::format("--format takes {}; \"{}\" given", fmt::join(format_names, ", "), name));
}

std::string as_gradescope(const Result& result) {
  Json tests = Json::array();
  int number = 0;
  for (const CaseResult& one : result.cases) {
    tests.push_back({{"score", rounded(one.points)},
                     {"max_score", rounded(one.most)},
                     {"status", one.status == Status::passed ? "passed" : "failed"},
                     {"name", one.name},
                     {"number", std::to_string(++number)},
                     {"output", output_of(one)},
                     {"output_format", "text"},
                     {"visibility", one.hidden ? "hidden" : "visible"}});
  }
  Json json = {{"score", rounded(result.score)},
               {"execution_time", static_cast<int>(std::ceil(result.seconds))},
               {"tests", std::move(tests)}};
  if (!result.error.empty()) {
    json["output"] = result.error;
    json["output_format"] = "text";
  }
  return text_of(json) + "\n";
}

std::string as_prairielearn(const Result& result, const std::filesystem::path& folder) {
  Json tests = Json::array();
  std::size_t left = prairielearn_limit;
  for (const CaseResult& one : result.cases) {
    Json test = {{"name", one.name},
                 {"points", rounded(one.points)},
                 {"max_points", rounded(one.most)},
                 {"output", one.hidden ? std::string() : output_of(one)}};
    tests.push_back(std::move(test));
  }
  Json json = {{"gradable", true},
               {"score", result.most > 0 ? rounded(result.score / result.most) : 0.0},
               {"output", result.error},
               {"tests", std::move(tests)}};
  left -= std::min(left, text_of(json).size() + 4096);
  for (std::size_t i = 0; i < result.cases.size(); ++i) {
    const CaseResult& one = result.cases[i];
    Json images = Json::array();
    for (const char* role : {"yours", "difference"}) {
      const auto found = one.pictures.find(role);
      if (one.hidden || found == one.pictures.end()) continue;
      const std::string url = "data:image/png;base64," + base64(read_text(folder / found->second));
      if (url.size() + 200 > left) continue;
      left -= url.size() + 200;
      images.push_back({{"label", fmt::format("{}: {}", one.name, role)}, {"url", url}});
    }
    if (!images.empty()) json["tests"][i]["images"] = std::move(images);
  }
  return text_of(json) + "\n";
}

std::string as_autolab(const Result& result) {
  Json scores = Json::object();
  for (const CaseResult& one : result.cases) scores[one.name] = rounded(one.points);
  return text_of({{"scores", std::move(scores)}}, -1) + "\n";
}

std::string as_junit(std::span<const Result> results) {
  std::size_t tests = 0, failures = 0, errors = 0;
  std::string suites;
  for (const Result& result : results) {
    std::size_t failed = 0, broken = 0;
    std::string cases;
    for (const CaseResult& one : result.cases) {
      failed += one.status == Status::failed;
      broken += one.status == Status::error;
      cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                           in_xml(result.lab), in_xml(one.name), one.milliseconds / 1000);
      if (one.status == Status::passed) {
        cases += "/>\n";
        continue;
      }
      const char* tag = one.status == Status::failed ? "failure" : "error";
      cases += fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", tag,
                           in_xml(fmt::format("{}", fmt::join(one.says, " "))));
    }
    suites += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}"
        "  </testsuite>\n",
        in_xml(result.submission), result.cases.size(), failed, broken, result.seconds, cases);
    tests += result.cases.size();
    failures += failed;
    errors += broken;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}</testsuites>\n",
      tests, failures, errors, suites);
}

std::string as_json(std::span<const Result> results) {
  Json list = Json::array();
  for (const Result& result : results) list.push_back(to_json(result));
  return text_of(list) + "\n";
}

}  // namespace shadowlab::lab
