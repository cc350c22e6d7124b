-- Accumulates for ever.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do gl.Accum(gl.ACCUM, 1.0) end
  end,
}
