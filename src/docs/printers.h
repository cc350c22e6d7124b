#pragma once

#include <string>

namespace shadowlab::docs {

/// The reference, as Markdown.
std::string reference();

/// The same for editors with the Lua language server: its annotations over empty functions.
std::string stub();

}  // namespace shadowlab::docs
