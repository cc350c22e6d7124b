#include "docs/signature.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace shadowlab::docs {
namespace {

bool of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// What stands between commas that are in no bracket.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ',';
    depth += std::string_view("({[").find(c) != std::string_view::npos;
    depth -= std::string_view(")}]").find(c) != std::string_view::npos;
    if (c != ',' || (depth > 0 && i < text.size())) continue;
    std::string_view part = text.substr(begin, i - begin);
    while (part.starts_with(' ')) part.remove_prefix(1);
    if (!part.empty()) parts.push_back(part);
    begin = i + 1;
  }
  return parts;
}

std::string argument_name(std::string_view part, const std::vector<std::string>& before) {
  if (part.ends_with("…") || part == "...") return "...";
  std::size_t length = 0;
  while (length < part.size() && of_a_name(part[length])) ++length;
  std::string name(part.substr(0, length));
  if (name.empty()) name = "values";  // a table in braces
  if (name == "function" || name == "end") name = "fn";
  const auto taken = [&](const std::string& candidate) {
    return std::find(before.begin(), before.end(), candidate) != before.end();
  };
  std::string unique = name;
  for (int i = 2; taken(unique); ++i) unique = name + std::to_string(i);
  return unique;
}

std::string type_of(std::string_view result) {
  if (result.starts_with('{')) return "table";
  while (!result.empty() && !of_a_name(result.back())) result.remove_suffix(1);  // "integer…"
  const std::size_t space = result.rfind(' ');
  std::string word(space == std::string_view::npos ? result : result.substr(space + 1));
  constexpr std::array same{"vec2",    "vec3",   "vec4",    "mat3",  "mat4",   "quat",
                            "integer", "number", "string",  "mesh",  "shader", "scene",
                            "object",  "camera", "boolean", "volume"};
  if (std::find(same.begin(), same.end(), word) != same.end()) return word;
  if (word == "text") return "string";
  if (word == "arrays") return "gl.vertex_array";
  if (word == "queries" || word == "query") return "gl.query";
  if (word.ends_with('s')) word.pop_back();
  constexpr std::array objects{"texture", "sampler", "framebuffer", "renderbuffer",
                               "buffer",  "shader",  "program"};
  if (std::find(objects.begin(), objects.end(), word) != objects.end()) return "gl." + word;
  return "any";
}

}  // namespace

Signature parse(std::string_view signature) {
  Signature parsed;
  const std::size_t open = signature.find_first_of("({");
  parsed.callee = signature.substr(0, open);
  if (open == std::string_view::npos) return parsed;
  int depth = 0;
  std::size_t close = open;
  for (; close < signature.size(); ++close) {
    depth += signature[close] == '(' || signature[close] == '{';
    depth -= signature[close] == ')' || signature[close] == '}';
    if (depth == 0) break;
  }
  if (signature[open] == '{') {
    parsed.arguments.push_back("fields");
  } else {
    for (const auto part : split(signature.substr(open + 1, close - open - 1)))
      parsed.arguments.push_back(argument_name(part, parsed.arguments));
  }
  const std::size_t arrow = signature.find("-> ");
  if (arrow == std::string_view::npos) return parsed;
  for (const auto part : split(signature.substr(arrow + 3)))
    parsed.results.push_back(type_of(part));
  return parsed;
}

}  // namespace shadowlab::docs
