// The module `random` of a manifest: cases that nobody can have drawn beforehand.
#pragma once

#include <cstdint>
#include <random>

#include "lua/state.h"

namespace shadowlab::lab {

/// Gives the state a global `random` whose functions draw from `generator`, which outlives it; the
/// same seed gives the same numbers on every machine. Protected: State::run.
void open_random(lua_State* L, std::mt19937_64& generator);

}  // namespace shadowlab::lab
