// Results as other programs take them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "lab/results.h"

namespace shadowlab::lab {

enum class Format { json, gradescope, prairielearn, autolab, junit };
/// "json", "gradescope" … Throws InputError for another.
Format format_named(std::string_view name);

/// Gradescope's results.json of one submission: score, execution_time, tests. A hidden case has
/// visibility "hidden". Source: gradescope-autograders.readthedocs.io, "Autograder Specifications".
std::string as_gradescope(const Result& result);

/// PrairieLearn's results.json of one submission: gradable, score from 0 to 1, tests, and the
/// pictures of `folder` as data URLs, as many as keep it under 1 MB. Hidden cases are told without
/// their output. Source: PrairieLearn's documentation, "External grading".
std::string as_prairielearn(const Result& result, const std::filesystem::path& folder);

/// Autolab's last line of standard output: {"scores": {"CASE": points, …}}. Source: Autolab's
/// documentation, "Guide for Lab Authors".
std::string as_autolab(const Result& result);

/// A test suite a submission, a test case a case. Source: the schema of Apache Ant's JUnit task.
std::string as_junit(std::span<const Result> results);

/// All results as a list, each as its result.json.
std::string as_json(std::span<const Result> results);

}  // namespace shadowlab::lab
