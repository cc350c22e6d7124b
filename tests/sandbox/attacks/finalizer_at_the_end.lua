-- Leaves a finalizer for the end of the state that never stops.
-- expect: recipe error
-- says: __gc
return {
  draw = function(r)
    kept = setmetatable({}, { __gc = function() while true do end end })
  end,
}
