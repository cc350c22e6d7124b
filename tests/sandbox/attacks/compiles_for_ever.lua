-- Compiles one shader after the other.
-- expect: recipe error or timed out or out of memory
-- job: 1.5 s
return {
  draw = function(r)
    local i = 0
    while true do
      i = i + 1
      local s = shader.compile {
        vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
        fragment = ("#version 330 core\nout vec4 color;\nvoid main() { color = vec4(%d.0); }"):format(i),
      }
      mesh.quad():draw(s)
    end
  end,
}
