// The commands of the program: each file adds one to the command line.
#pragma once

#include <CLI/CLI.hpp>

namespace shadowlab::cli {

/// How a command ends: 0 done; 1 done, and the answer is no. Wrong input (2) and a machine that
/// cannot (3) are exceptions.
enum class Answer { yes = 0, no = 1 };

/// Sets `answer` when the command runs.
void add_run(CLI::App& app, Answer& answer);
void add_trace(CLI::App& app, Answer& answer);
void add_list(CLI::App& app, Answer& answer);
void add_new(CLI::App& app, Answer& answer);
void add_diff(CLI::App& app, Answer& answer);
void add_gallery(CLI::App& app, Answer& answer);
void add_doctor(CLI::App& app, Answer& answer);

}  // namespace shadowlab::cli
