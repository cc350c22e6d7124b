-- Draws nothing.
-- expect: finished
return {
  draw = function(r)

  end,
}
