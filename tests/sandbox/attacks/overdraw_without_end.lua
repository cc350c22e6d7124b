-- Full screens of triangles, as many as time allows.
-- expect: recipe error or timed out
-- job: 1.5 s
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { float x = 0.0; for (int i = 0; i < 1000; ++i) x += sin(gl_FragCoord.x * float(i)); color = vec4(x); }",
    }
    local quad = mesh.quad()
    while true do quad:draw(s) end
  end,
}
