// What a key does to a parameter: the recipe's `keys`, for a window.
//
//   keys = { s = "toggle soft", ["["] = "multiply samples 0.5" }
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lua/boxes.h"

namespace shadowlab::recipe {

struct NamedParameter;

struct KeyAction {
  enum class Verb {
    toggle,    ///< a toggle, or between two values
    next,      ///< the next of a choice's names, the first after the last
    add,       ///< to each number, within the parameter's range
    multiply,  ///< each number; an integer changes by at least 1
  };
  std::string key;    ///< one character, as it is typed
  std::string words;  ///< "toggle darkness 0 0.35", as the recipe has it
  Verb verb;
  std::string parameter;  ///< its name
  std::vector<double> numbers;
};

/// Reads "toggle NAME", "toggle NAME A B", "next NAME", "add NAME STEP…", "multiply NAME FACTOR".
/// Throws InputError for other words, and for a parameter that is not there or is of another kind.
KeyAction key_action(std::string_view key, std::string_view words,
                     std::span<const NamedParameter> parameters);

/// The parameter after the key was pressed: as set_value takes it.
std::string pressed(const KeyAction& action, const lua::Parameter& parameter);

}  // namespace shadowlab::recipe
