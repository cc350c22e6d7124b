-- The scene that a test has made: see tests/given.lua.
return require("given").world
