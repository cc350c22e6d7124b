// A recipe's table `sweep`: what of it is worth varying.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "recipe/recipe.h"

namespace shadowlab::recipe {

/// The field sweep = { NAME = { value, … } } of the recipe's table at `table`; empty without one.
/// Throws InputError, naming `file`, for names that are no parameter and for values that the
/// parameter does not take.
std::vector<Swept> read_sweep(lua_State* L, int table, const std::string& file,
                              std::span<const NamedParameter> parameters);

}  // namespace shadowlab::recipe
