-- A sphere of 2^31 slices.
-- expect: recipe error
return {
  draw = function(r)
    mesh.sphere(1, 1 << 31, 1 << 31)
  end,
}
