-- 1e9 instances of a triangle.
-- expect: recipe error or timed out
-- job: 1.5 s
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID % 3, gl_VertexID % 2, 0, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }",
    }
    s:use {}
    gl.BindVertexArray(gl.GenVertexArrays(1))
    gl.DrawArraysInstanced(gl.TRIANGLES, 0, 3, 1000000000)
  end,
}
