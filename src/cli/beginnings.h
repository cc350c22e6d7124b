// What `shadowlab new` writes.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shadowlab::cli {

/// A recipe that draws: a projected shadow in three passes.
std::string recipe_to_begin_with(const std::string& file, const std::string& title);

/// The files of a lab, by their names in its folder: that recipe, with a gap.
std::vector<std::pair<std::string, std::string>> lab_to_begin_with(const std::string& title);

}  // namespace shadowlab::cli
