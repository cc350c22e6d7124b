// What a frame did and why, pass by pass, in sentences.
#pragma once

#include <cstdio>

#include "cli/session.h"

namespace shadowlab::cli {

/// Prints of the session's last frame: below each pass its decisions, what it drew and what it sent
/// to GL; then the frame's sums, and what GL holds at its end. The recipe must have been made with
/// Options::explain.
void print_explanation(Session& session, std::FILE* to);

}  // namespace shadowlab::cli
