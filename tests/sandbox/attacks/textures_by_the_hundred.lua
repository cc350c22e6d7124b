-- A hundred textures of 16384 x 16384.
-- expect: recipe error
-- says: memory
return {
  draw = function(r)
    for i = 1, 100 do
      gl.BindTexture(gl.TEXTURE_2D, gl.GenTextures(1))
      gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 16384, 16384, 0, gl.RGBA, gl.FLOAT, nil)
    end
  end,
}
