// The window's own keys: one table for what they do and for the help that lists them.
#pragma once

#include <span>

#include "live/studio.h"
#include "live/view.h"

namespace shadowlab::live {

struct Command {
  context::Key key;
  char character;
  context::Modifiers modifiers;
  const char* keys;  ///< as the help names them; null: listed with the one before
  const char* does;
  void (*run)(Studio&, View&);
};
std::span<const Command> commands();

/// Runs what the key means; whether it means anything. Throws InputError.
bool run_command(const context::KeyEvent& event, Studio& studio, View& view);

/// Less or more of a parameter, by a step that suits its range; the next of a choice.
std::string stepped(const lua::Parameter& parameter, int by);

}  // namespace shadowlab::live
