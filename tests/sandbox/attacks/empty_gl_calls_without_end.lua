-- Calls GL for ever: no instruction of Lua is long, no call of GL is.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do gl.Clear(gl.COLOR_BUFFER_BIT) end
  end,
}
