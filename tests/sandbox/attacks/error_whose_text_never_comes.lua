-- Fails with an object whose text never comes.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    error(setmetatable({}, { __tostring = function() while true do end end }))
  end,
}
