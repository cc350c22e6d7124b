-- Never stops, in a coroutine.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    coroutine.wrap(function() while true do end end)()
  end,
}
