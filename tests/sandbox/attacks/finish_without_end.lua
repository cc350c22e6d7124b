-- Waits for GL for ever.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    while true do gl.Finish() end
  end,
}
