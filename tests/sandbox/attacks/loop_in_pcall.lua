-- Never stops, inside of pcall.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do pcall(function() while true do end end) end
  end,
}
