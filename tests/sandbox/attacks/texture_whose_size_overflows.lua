-- A texture whose size overflows 32 and 64 bits.
-- expect: recipe error
return {
  draw = function(r)
    gl.BindTexture(gl.TEXTURE_3D, gl.GenTextures(1))
    gl.TexImage3D(gl.TEXTURE_3D, 0, gl.RGBA32F, 65536, 65536, 65536, 0, gl.RGBA, gl.FLOAT, nil)
  end,
}
