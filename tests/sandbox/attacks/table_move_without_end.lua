-- Moves a table of 2^60 places.
-- expect: recipe error
return {
  draw = function(r)
    table.move({}, 1, 1 << 60, 2)
  end,
}
