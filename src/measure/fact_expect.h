// What tests written in Lua expect with: expect, expect_equal, expect_near, expect_error.
#pragma once

#include "lua/state.h"

namespace shadowlab::measure {

/// Makes them globals.
void open_expect(lua_State* L);

}  // namespace shadowlab::measure
