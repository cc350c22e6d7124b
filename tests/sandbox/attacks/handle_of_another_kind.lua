-- Uses a buffer as a texture.
-- expect: recipe error
return {
  draw = function(r)
    gl.BindTexture(gl.TEXTURE_2D, gl.GenBuffers(1))
  end,
}
