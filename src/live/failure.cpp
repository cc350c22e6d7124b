#include "live/failure.h"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace shadowlab::live {
namespace {

constexpr int lines_around = 3;
constexpr std::size_t longest_line = 160;

// The end of "FILE:LINE: " at the beginning of `text` where FILE is a file that is there; 0 where
// there is none. Names may hold colons.
std::size_t take_position(std::string_view text, Failure& failure) {
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
       colon = text.find(':', colon + 1)) {
    int line = 0;
    const char* const end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data() + colon + 1, end, line);
    if (error != std::errc() || line < 1 || !std::string_view(after, end).starts_with(": "))
      continue;
    std::error_code none;
    const std::filesystem::path file(text.substr(0, colon));
    if (!std::filesystem::is_regular_file(file, none)) continue;
    failure.file = file.string();
    failure.line = line;
    return static_cast<std::size_t>(after - text.data()) + 2;
  }
  return 0;
}

std::size_t take_pass(std::string_view text, Failure& failure) {
  constexpr std::string_view word = "in pass \"";
  if (!text.starts_with(word)) return 0;
  const std::size_t end = text.find("\": ", word.size());
  if (end == std::string_view::npos) return 0;
  failure.pass = text.substr(word.size(), end - word.size());
  return end + 3;
}

std::vector<SourceLine> lines_of(const std::string& file, int middle) {
  std::vector<SourceLine> lines;
  std::ifstream stream(file);
  std::string text;
  for (int number = 1; number <= middle + lines_around && std::getline(stream, text); ++number) {
    if (number < middle - lines_around) continue;
    if (text.size() > longest_line) text.resize(longest_line);
    std::ranges::replace(text, '\t', ' ');
    std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < ' '; });
    lines.push_back({number, text});
  }
  return lines;
}

}  // namespace

std::string_view name_of(Failure::Stage stage) {
  switch (stage) {
    case Failure::Stage::loading:
      return "loading";
    case Failure::Stage::setup:
      return "setup";
    case Failure::Stage::frame:
      break;
  }
  return "drawing";
}

Failure failure_of(std::string_view error, Failure::Stage stage) {
  Failure failure;
  failure.stage = stage;
  error.remove_prefix(take_position(error, failure));
  error.remove_prefix(take_pass(error, failure));
  // A shader's error names a place of its own, which tells more than that of shader.load.
  Failure inner;
  if (const std::size_t length = take_position(error, inner)) {
    failure.file = inner.file;
    failure.line = inner.line;
    error.remove_prefix(length);
  }
  failure.sentence = error;
  if (failure.line > 0) failure.around = lines_of(failure.file, failure.line);
  return failure;
}

}  // namespace shadowlab::live
