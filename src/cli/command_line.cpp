// What is said of a command line that cannot be read.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>

#include "cli/commands.h"
#include "core/near_names.h"

namespace shadowlab::cli {
namespace {

// The words that this command and its options are called by.
std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

// CLI11's sentences where a user would not understand them.
std::string in_words(const CLI::ParseError& problem) {
  std::string text = problem.what();
  constexpr std::string_view converting = "Could not convert: ";  // "--frames = abc"
  if (text.starts_with(converting))
    return text.substr(converting.size()) + " is no number that it takes";
  if (problem.get_name() == "ArgumentMismatch")
    return text.substr(0, text.find(':')) + " needs a value, and one only";
  return text;
}

}  // namespace

CLI::Validator one_of(std::initializer_list<std::string_view> words) {
  const std::vector<std::string_view> names(words);
  return {[names](std::string& given) {
            for (const auto name : names) {
              if (given == name) return std::string();
            }
            return fmt::format("{} is none of {}{}", given, fmt::join(names, ", "),
                               did_you_mean(given, names));
          },
          {}};
}

std::string sentence_of(const CLI::ParseError& problem, const CLI::App& app) {
  const auto given = app.get_subcommands();
  const CLI::App& command = given.empty() ? app : *given.front();
  const std::string name = command.get_name();
  std::string sentence = in_words(problem);
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && option->count() == 0) {
      sentence = fmt::format("{} needs {}", name, option->get_type_name());
      break;
    }
  }
  const auto extras = command.remaining(true);
  if (!extras.empty()) {
    const auto names = names_of(command);
    const std::vector<std::string_view> near(names.begin(), names.end());
    const std::string word = extras.front().substr(0, extras.front().find('='));
    const bool command_missing = given.empty() && !word.starts_with('-');
    sentence = command_missing ? fmt::format("there is no command {}", word)
                               : fmt::format("{} does not take {}", name, extras.front());
    const std::string hint = word.size() > 2 ? did_you_mean(word, near) : "";
    if (!hint.empty()) return sentence + hint;
  }
  // CLI11 puts a positional argument's own name in front of what its check says.
  for (const char* positional : {"what: ", "name: "}) {
    if (sentence.starts_with(positional)) sentence.erase(0, std::strlen(positional));
  }
  if (sentence.ends_with('?')) return sentence;
  return fmt::format("{} (see shadowlab {}--help)", sentence, given.empty() ? "" : name + " ");
}

}  // namespace shadowlab::cli
