-- Gives the globals a metatable.
-- expect: recipe error or finished
return {
  draw = function(r)
    setmetatable(_G, { __index = function() while true do end end })
    return undefined_name
  end,
}
