-- A shader of 50 MB.
-- expect: recipe error or timed out or out of memory
-- job: 1.5 s
-- memory: 256 MiB
return {
  draw = function(r)
    local text = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1);\n" .. ("color += vec4(1);\n"):rep(3000000) .. "}"
    shader.compile { vertex = "#version 330 core\nvoid main() { gl_Position = vec4(0); }", fragment = text }
  end,
}
