-- Gives a table a finalizer that never stops.
-- expect: recipe error
-- says: __gc
return {
  draw = function(r)
    setmetatable({}, { __gc = function() while true do end end })
    for _ = 1, 1e5 do local t = {} end
  end,
}
