-- Uses objects of others by their numbers.
-- expect: recipe error
return {
  draw = function(r)
    for i = 1, 100 do gl.BindTexture(gl.TEXTURE_2D, i) end
  end,
}
