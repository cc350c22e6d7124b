// "did you mean …?": the name nearest to a misspelt one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace shadowlab {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into
/// `b` (optimal string alignment distance), capital and small letters being the same.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name among `names` nearest to `name`, if it is near enough to be a misspelling of it: at
/// most a third of its letters differ. Of equally near names, the first.
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> names);

/// "; did you mean NAME?" or nothing: the end of an error sentence.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> names);

}  // namespace shadowlab
