-- Uses a texture after it was deleted.
-- expect: recipe error
return {
  draw = function(r)
    local t = gl.GenTextures(1)
    gl.DeleteTextures(1, t)
    gl.BindTexture(gl.TEXTURE_2D, t)
  end,
}
