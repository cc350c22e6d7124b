-- Reads pixels for ever.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do gl.ReadPixels(0, 0, r.width, r.height, gl.RGBA, gl.FLOAT) end
  end,
}
