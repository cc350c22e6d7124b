-- A grid of 1e10 squares.
-- expect: recipe error
return {
  draw = function(r)
    mesh.grid(1, 1, 100000, 100000, function() return 0 end)
  end,
}
