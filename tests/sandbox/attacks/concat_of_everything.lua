-- Joins a table that says that it has 2^26 places.
-- expect: recipe error or finished
return {
  draw = function(r)
    table.concat(setmetatable({}, { __index = function() return "x" end, __len = function() return 1 << 26 end }), "x")
  end,
}
