-- A million GL objects.
-- expect: recipe error or finished
return {
  draw = function(r)
    for i = 1, 1000000 do gl.GenTextures(1) end
  end,
}
