-- Fails with an object whose text never comes.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    error(setmetatable({}, { __tostring = function() while true do end end }))
  end,
}
