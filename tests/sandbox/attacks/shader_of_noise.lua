-- A shader of bytes that are no text.
-- expect: recipe error
return {
  draw = function(r)
    local t = {}
    for i = 0, 255 do t[#t + 1] = string.char(i) end
    shader.compile { vertex = table.concat(t):rep(100), fragment = "\0\0\0" }
  end,
}
