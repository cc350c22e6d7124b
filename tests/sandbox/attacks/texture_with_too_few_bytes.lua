-- A texture with fewer bytes than it needs.
-- expect: recipe error
return {
  draw = function(r)
    gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1))
    gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1024, 1024, 0, gl.RGBA, gl.UNSIGNED_BYTE, "short")
  end,
}
