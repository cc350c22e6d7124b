-- A teapot cut a million times.
-- expect: recipe error
return {
  draw = function(r)
    mesh.teapot(1, 1000000)
  end,
}
