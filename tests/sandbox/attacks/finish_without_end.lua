-- Waits for GL for ever.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do gl.Finish() end
  end,
}
