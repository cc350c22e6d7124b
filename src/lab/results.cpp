#include "lab/results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace shadowlab::lab {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Status status) {
  switch (status) {
    case Status::passed:
      return "passed";
    case Status::failed:
      return "failed";
    default:
      return "error";
  }
}

Status status_of(const std::string& name) {
  if (name == "passed") return Status::passed;
  return name == "failed" ? Status::failed : Status::error;
}

// JSON's numbers are doubles to many readers; 64 bits are safe as text.
std::string hex(std::uint64_t number) { return fmt::format("{:016x}", number); }

std::uint64_t from_hex(const nlohmann::json& json) {
  return std::stoull(json.get<std::string>(), nullptr, 16);
}

Json to_json(const Finding& finding) {
  return {{"pass", finding.pass},       {"pass_number", finding.pass_number},
          {"buffer", finding.buffer},   {"region", finding.region},
          {"place", finding.place},     {"pixels", finding.pixels},
          {"mistake", finding.mistake}, {"hint", finding.hint},
          {"state", finding.state},     {"mended", finding.mended}};
}

Finding finding_from(const nlohmann::json& json) {
  Finding finding;
  json.at("pass").get_to(finding.pass);
  json.at("pass_number").get_to(finding.pass_number);
  json.at("buffer").get_to(finding.buffer);
  json.at("region").get_to(finding.region);
  json.at("place").get_to(finding.place);
  json.at("pixels").get_to(finding.pixels);
  json.at("mistake").get_to(finding.mistake);
  json.at("hint").get_to(finding.hint);
  json.at("state").get_to(finding.state);
  json.at("mended").get_to(finding.mended);
  return finding;
}

Json to_json(const CaseResult& one) {
  Json json = {{"name", one.name},
               {"points", one.points},
               {"max_points", one.most},
               {"hidden", one.hidden},
               {"status", name_of(one.status)},
               {"compared", one.compared},
               {"differing", one.differing},
               {"forgiven", one.forgiven},
               {"budget", one.budget},
               {"milliseconds", one.milliseconds},
               {"settings", one.settings},
               {"says", one.says},
               {"pictures", one.pictures}};
  if (one.finding) json["finding"] = to_json(*one.finding);
  return json;
}

CaseResult case_from(const nlohmann::json& json) {
  CaseResult one;
  json.at("name").get_to(one.name);
  json.at("points").get_to(one.points);
  json.at("max_points").get_to(one.most);
  json.at("hidden").get_to(one.hidden);
  one.status = status_of(json.at("status").get<std::string>());
  json.at("compared").get_to(one.compared);
  json.at("differing").get_to(one.differing);
  json.at("forgiven").get_to(one.forgiven);
  json.at("budget").get_to(one.budget);
  json.at("milliseconds").get_to(one.milliseconds);
  json.at("settings").get_to(one.settings);
  json.at("says").get_to(one.says);
  json.at("pictures").get_to(one.pictures);
  if (json.contains("finding")) one.finding = finding_from(json.at("finding"));
  return one;
}

}  // namespace

nlohmann::ordered_json to_json(const Result& result) {
  Json cases = Json::array();
  for (const CaseResult& one : result.cases) cases.push_back(to_json(one));
  return {{"submission", result.submission},
          {"file", result.file},
          {"lab", result.lab},
          {"title", result.title},
          {"digest", hex(result.digest)},
          {"score", result.score},
          {"max_score", result.most},
          {"seconds", result.seconds},
          {"verdict", result.verdict},
          {"error", result.error},
          {"printed", result.printed},
          {"layers", result.layers},
          {"trace", hex(result.trace)},
          {"cases", std::move(cases)}};
}

Result result_from(const nlohmann::json& json) {
  try {
    Result result;
    json.at("submission").get_to(result.submission);
    json.at("file").get_to(result.file);
    json.at("lab").get_to(result.lab);
    json.at("title").get_to(result.title);
    result.digest = from_hex(json.at("digest"));
    json.at("score").get_to(result.score);
    json.at("max_score").get_to(result.most);
    json.at("seconds").get_to(result.seconds);
    json.at("verdict").get_to(result.verdict);
    json.at("error").get_to(result.error);
    json.at("printed").get_to(result.printed);
    json.at("layers").get_to(result.layers);
    result.trace = from_hex(json.at("trace"));
    for (const auto& one : json.at("cases")) result.cases.push_back(case_from(one));
    return result;
  } catch (const std::exception& problem) {
    throw InputError(fmt::format("this is no result of shadowlab grade ({})", problem.what()));
  }
}

std::string text_of(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace shadowlab::lab
