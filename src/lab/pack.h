// A lab as it is given away: to students, or to Gradescope.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/manifest.h"
#include "lab/reference.h"
#include "lab/zip.h"

namespace shadowlab::lab {

/// The exercise, the template, the cases that are not hidden with the numbers that were drawn for
/// them, and what they shall look like; no solution, no mistakes, nothing of hidden cases.
std::vector<Packed> pack_for_student(const Lab& lab, const Reference& reference);

/// An autograder for Gradescope: setup.sh, run_autograder, this program with its scripts and
/// shaders, its source for images where it does not run, and the whole lab. `home` is
/// shadowlab::home(), `program` the file that runs.
std::vector<Packed> pack_for_gradescope(const Lab& lab, const std::filesystem::path& home,
                                        const std::filesystem::path& program);

}  // namespace shadowlab::lab
