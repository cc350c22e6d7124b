// Reading GLSL and drivers' logs as text: what GL itself cannot tell.
#include <cctype>
#include <charconv>

#include "gl/program.h"

namespace shadowlab::gl {
namespace {

std::string without_comments(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 2) == "//") {
      i = text.find('\n', i);
      if (i == std::string_view::npos) break;
      plain += '\n';
    } else if (text.substr(i, 2) == "/*") {
      i = text.find("*/", i + 2);
      if (i == std::string_view::npos) break;
      ++i;
      plain += ' ';
    } else {
      plain += text[i];
    }
  }
  return plain;
}

bool of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::vector<std::string> tokens(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < text.size();) {
    if (of_a_word(text[i])) {
      std::size_t end = i;
      while (end < text.size() && of_a_word(text[end])) ++end;
      list.push_back(text.substr(i, end - i));
      i = end;
    } else {
      if (!std::isspace(static_cast<unsigned char>(text[i]))) list.push_back(text.substr(i, 1));
      ++i;
    }
  }
  return list;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
    text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
    text.remove_suffix(1);
  return text;
}

// Source string and line number in "0:12(5): …" or "0(12) : …", and what follows them.
struct Numbered {
  int source;
  int line;
  std::string_view text;
};
std::optional<Numbered> numbered(std::string_view line) {
  if (line.starts_with("ERROR: ")) line.remove_prefix(7);
  int source = 0, number = 0;
  const char* const end = line.data() + line.size();
  auto [after, error] = std::from_chars(line.data(), end, source);
  if (error != std::errc() || after == end || (*after != ':' && *after != '(')) return {};
  const auto second = std::from_chars(after + 1, end, number);
  if (second.ec != std::errc()) return {};
  std::string_view rest(second.ptr, static_cast<std::size_t>(end - second.ptr));
  if (rest.starts_with('(')) rest = rest.substr(std::min(rest.size(), rest.find(')') + 1));
  while (!rest.empty() && (rest.front() == ')' || rest.front() == ':' || rest.front() == ' ')) {
    rest.remove_prefix(1);
  }
  return Numbered{source, number, rest};
}

}  // namespace

std::string first_shader_error(std::string_view log, std::string_view source_name,
                               std::span<const std::string> included) {
  std::string_view rest = log;
  std::optional<Numbered> first;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const auto line = numbered(trimmed(rest.substr(0, end)));
    const bool is_error = line && line->text.find("warning") == std::string_view::npos;
    if (is_error && !first) first = line;
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  std::string where(source_name);
  if (!first) return where + ": " + std::string(trimmed(log));
  if (first->source >= 1 && static_cast<std::size_t>(first->source) <= included.size())
    where = included[static_cast<std::size_t>(first->source) - 1];
  std::string_view text = first->text;
  if (text.starts_with("error: ")) text.remove_prefix(7);
  return where + ":" + std::to_string(first->line) + ": " + std::string(text);
}

std::vector<std::string> declared_uniforms(std::string_view glsl) {
  std::vector<std::string> names;
  const auto list = tokens(without_comments(glsl));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] != "uniform") continue;
    // uniform [precision] type name [array] [= value] {, name …};
    std::size_t at = i + 1;
    if (at < list.size() && (list[at] == "highp" || list[at] == "mediump" || list[at] == "lowp"))
      ++at;
    bool expects_name = true;
    int depth = 0;
    for (++at; at < list.size() && list[at] != ";"; ++at) {
      if (list[at] == "(" || list[at] == "[" || list[at] == "{") ++depth;
      if (list[at] == ")" || list[at] == "]" || list[at] == "}") --depth;
      if (depth == 0 && list[at] == ",") expects_name = true;
      if (depth == 0 && expects_name && of_a_word(list[at][0])) {
        names.push_back(list[at]);
        expects_name = false;
      }
    }
  }
  return names;
}

}  // namespace shadowlab::gl
