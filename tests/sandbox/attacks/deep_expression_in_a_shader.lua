-- A shader that nests a hundred thousand deep.
-- expect: recipe error or crashed or out of memory or timed out
-- job: 1.5 s
return {
  draw = function(r)
    shader.compile { vertex = "#version 330 core\nvoid main() { float x = " .. ("("):rep(100000) .. "1.0" .. (")"):rep(100000) .. "; gl_Position = vec4(x); }", fragment = "#version 330 core\nvoid main() {}" }
  end,
}
