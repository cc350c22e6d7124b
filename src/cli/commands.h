// The commands of the program: each file adds one to the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <string_view>

namespace shadowlab::cli {

/// How a command ends: 0 done; 1 done, and the answer is no. Wrong input (2) and a machine that
/// cannot (3) are exceptions.
enum class Answer { yes = 0, no = 1 };

/// The option takes one of these words, which must outlive it.
CLI::Validator one_of(std::initializer_list<std::string_view> words);

/// The sentence for a command line that `app` does not take, with near names.
std::string sentence_of(const CLI::ParseError& problem, const CLI::App& app);

/// Sets `answer` when the command runs.
void add_run(CLI::App& app, Answer& answer);
void add_trace(CLI::App& app, Answer& answer);
void add_list(CLI::App& app, Answer& answer);
void add_new(CLI::App& app, Answer& answer);
void add_diff(CLI::App& app, Answer& answer);
void add_gallery(CLI::App& app, Answer& answer);
void add_doctor(CLI::App& app, Answer& answer);
void add_check(CLI::App& app, Answer& answer);
void add_live(CLI::App& app, Answer& answer);
void add_worker(CLI::App& app, Answer& answer);
void add_grade(CLI::App& app, Answer& answer);
void add_merge(CLI::App& app, Answer& answer);
void add_pack(CLI::App& app, Answer& answer);
void add_measure(CLI::App& app, Answer& answer);
void add_stress(CLI::App& app, Answer& answer);

}  // namespace shadowlab::cli
