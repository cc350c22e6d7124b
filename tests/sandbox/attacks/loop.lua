-- Never stops.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    while true do end
  end,
}
