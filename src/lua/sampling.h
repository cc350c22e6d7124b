// How recipes say which points of a light are taken.
#pragma once

#include <cstdint>
#include <span>

#include "lua/boxes.h"
#include "shadow/samples.h"

namespace shadowlab::lua {

/// As many as a recipe may ask for: one frame that draws them all would take hours.
inline constexpr int most_samples = 65536;

/// The pattern named at `index`. Throws InputError, with the near name, for another.
shadow::Pattern read_pattern(lua_State* L, int index, const char* function);
/// A whole number from 0 to 2^53.
std::uint64_t read_seed(lua_State* L, int index, const char* function);

std::span<const Entry> sample_functions();

}  // namespace shadowlab::lua
