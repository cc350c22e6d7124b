-- Never stops, in a coroutine.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    coroutine.wrap(function() while true do end end)()
  end,
}
