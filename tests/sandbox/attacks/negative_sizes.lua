-- Sizes below zero.
-- expect: recipe error
return {
  draw = function(r)
    gl.Viewport(0, 0, -1, -1)
  end,
}
