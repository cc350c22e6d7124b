// What came of grading, as values, and as the file that says it: result.json of each submission.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::lab {

/// How a case ended. `drawn` only while it waits for its verdict.
enum class Status { passed, failed, error };

/// Where and why a case's picture departs from the reference.
struct Finding {
  std::string pass;        ///< the first that departs; "" for the picture's end
  int pass_number = 0;     ///< from 1; 0 where no pass does
  std::string buffer;      ///< "color", "stencil", "depth"
  std::string region;      ///< "shadow", "lit", "edge", "ground": where most of it is
  std::string place;       ///< "top left" … "everywhere"
  std::size_t pixels = 0;  ///< that differ in that buffer
  std::string mistake;     ///< whose picture it is
  std::string hint;        ///< the mistake's, in the language of the run
  std::string state;       ///< the sentence on the state that differs
  bool mended = false;     ///< with that one state replaced, the picture is right
};

struct CaseResult {
  std::string name;
  double points = 0, most = 0;
  bool hidden = false;
  Status status = Status::error;
  std::string compared;  ///< what failed: "color", "stencil", "depth"
  std::size_t differing = 0, forgiven = 0, budget = 0;
  double milliseconds = 0;
  std::vector<std::string> settings;  ///< "light=0,4,0": how a student draws the case
  std::vector<std::string> says;      ///< sentences for the student
  std::optional<Finding> finding;
  std::map<std::string, std::string> pictures;  ///< file names in the submission's folder, by role
};

struct Result {
  std::string submission;  ///< its name in this run
  std::string file;        ///< the recipe's, without its folder
  std::string lab;
  std::string title;
  std::uint64_t digest = 0;  ///< of what was handed in
  double score = 0, most = 0;
  double seconds = 0;       ///< by the clock on the wall
  std::string verdict;      ///< "finished", "timed out" …
  std::string error;        ///< one sentence; empty where all was drawn
  std::string printed;      ///< the first lines
  std::string layers;       ///< of isolation, that held
  std::uint64_t trace = 0;  ///< digest of the GL calls: alike for near-duplicates
  std::vector<CaseResult> cases;

  bool passed() const { return score >= most - 1e-9; }
};

nlohmann::ordered_json to_json(const Result& result);
/// Throws InputError for what is no result.
Result result_from(const nlohmann::json& json);

/// JSON as text: what is no UTF-8 in names or printed lines is replaced.
std::string text_of(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace shadowlab::lab
