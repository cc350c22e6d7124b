-- Inserts in a table that says that it is 2^60 long.
-- expect: recipe error or finished
return {
  draw = function(r)
    local t = setmetatable({}, { __len = function() return 1 << 60 end })
    table.insert(t, 1, "x")
  end,
}
