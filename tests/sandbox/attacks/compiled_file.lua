Lua
-- Is compiled Lua.
-- expect: recipe error
-- says: compiled
