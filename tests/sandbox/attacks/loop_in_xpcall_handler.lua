-- Never stops, in the handler of its own error.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    xpcall(error, function() while true do end end)
    while true do end
  end,
}
