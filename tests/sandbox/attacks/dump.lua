-- Dumps a function.
-- expect: recipe error
-- says: dump
return {
  draw = function(r)
    string.dump(function() end)
  end,
}
