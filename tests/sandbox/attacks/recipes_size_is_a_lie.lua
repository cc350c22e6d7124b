-- Asks for a frame of its own of 16384 x 16384.
-- expect: recipe error or finished
return {
  draw = function(r)
    fbo.color(16384, 16384, gl.RGBA32F)
  end,
}
