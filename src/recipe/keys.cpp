#include "recipe/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/near_names.h"
#include "recipe/recipe.h"

namespace shadowlab::recipe {
namespace {

using lua::Parameter;

constexpr std::array<std::string_view, 4> verbs{"toggle", "next", "add", "multiply"};

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

[[noreturn]] void refuse(std::string_view key, std::string_view words, const std::string& why) {
  throw InputError(fmt::format("keys[\"{}\"] = \"{}\": {}", key, words, why));
}

std::size_t components(const Parameter& parameter) { return parameter.value.size(); }

bool is_numeric(const Parameter& parameter) {
  return parameter.kind != Parameter::Kind::choice && parameter.kind != Parameter::Kind::toggle;
}

// Why the verb cannot be used so; empty where it can.
std::string misuse(const KeyAction& action, const Parameter& parameter) {
  const std::size_t given = action.numbers.size();
  switch (action.verb) {
    case KeyAction::Verb::toggle:
      if (parameter.kind == Parameter::Kind::toggle)
        return given == 0 ? "" : "a toggle is true or false, and takes no values";
      if (components(parameter) != 1 || !is_numeric(parameter))
        return "it takes a toggle or a number";
      return given == 2 ? "" : "it takes two values to change between";
    case KeyAction::Verb::next:
      if (parameter.kind != Parameter::Kind::choice) return "it takes a choice";
      return given == 0 ? "" : "it takes no values";
    case KeyAction::Verb::add:
      if (!is_numeric(parameter)) return "it takes a number, a point, a direction or a colour";
      return given == components(parameter)
                 ? ""
                 : fmt::format("it takes {} number{}", components(parameter),
                               components(parameter) == 1 ? "" : "s");
    case KeyAction::Verb::multiply:
      if (!is_numeric(parameter)) return "it takes a number, a point, a direction or a colour";
      return given == 1 ? "" : "it takes one factor";
  }
  return "";
}

double moved(const KeyAction& action, const Parameter& parameter, std::size_t i) {
  const double before = parameter.value[i];
  const bool whole = parameter.kind == Parameter::Kind::integer;
  if (action.verb == KeyAction::Verb::add) return before + action.numbers[i];
  const double factor = action.numbers[0];
  const double after = before * factor;
  if (!whole) return after;
  // From 1, half and twice as many lead on.
  if (factor > 1) return std::max(before + 1, std::floor(after));
  return std::min(before - 1, std::ceil(after));
}

}  // namespace

KeyAction key_action(std::string_view key, std::string_view text,
                     std::span<const NamedParameter> parameters) {
  const std::vector<std::string> words = words_of(text);
  if (words.size() < 2) refuse(key, text, "it takes a verb and a parameter, as \"toggle clip\"");
  KeyAction action{std::string(key), std::string(text), KeyAction::Verb::toggle, words[1], {}};
  const auto verb = std::ranges::find(verbs, words[0]);
  if (verb == verbs.end())
    refuse(key, text, "there is no verb " + words[0] + did_you_mean(words[0], verbs));
  action.verb = static_cast<KeyAction::Verb>(verb - verbs.begin());
  for (std::size_t i = 2; i < words.size(); ++i) {
    double number = 0;
    const char* const end = words[i].data() + words[i].size();
    const auto [after, error] = std::from_chars(words[i].data(), end, number);
    if (error != std::errc() || after != end || !std::isfinite(number))
      refuse(key, text, words[i] + " is no number");
    action.numbers.push_back(number);
  }
  std::vector<std::string_view> names;
  for (const NamedParameter& known : parameters) {
    if (known.name == action.parameter) {
      if (const std::string why = misuse(action, known.parameter); !why.empty())
        refuse(key, text, why);
      return action;
    }
    names.push_back(known.name);
  }
  refuse(key, text,
         "there is no parameter " + action.parameter + did_you_mean(action.parameter, names));
}

std::string pressed(const KeyAction& action, const Parameter& parameter) {
  Parameter after = parameter;
  switch (action.verb) {
    case KeyAction::Verb::toggle:
      if (action.numbers.empty()) {
        after.value[0] = after.value[0] == 0 ? 1 : 0;
      } else {
        after.value[0] =
            after.value[0] == action.numbers[0] ? action.numbers[1] : action.numbers[0];
      }
      break;
    case KeyAction::Verb::next:
      after.value[0] = std::fmod(after.value[0] + 1, static_cast<double>(parameter.choices.size()));
      break;
    case KeyAction::Verb::add:
    case KeyAction::Verb::multiply:
      for (std::size_t i = 0; i < after.value.size(); ++i) {
        after.value[i] = moved(action, parameter, i);
        const bool ranged = parameter.kind == Parameter::Kind::number ||
                            parameter.kind == Parameter::Kind::integer ||
                            parameter.kind == Parameter::Kind::color;
        if (ranged) after.value[i] = std::clamp(after.value[i], parameter.least, parameter.most);
      }
      // The step that would end at no direction at all is not taken.
      if (parameter.kind == Parameter::Kind::direction &&
          after.value == std::vector<double>{0, 0, 0})
        after.value = parameter.value;
      break;
  }
  return lua::text_of(after);
}

}  // namespace shadowlab::recipe
