-- Draws attributes past the end of their buffer.
-- expect: recipe error
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }",
    }
    s:use {}
    gl.BindVertexArray(gl.GenVertexArrays(1))
    gl.BindBuffer(gl.ARRAY_BUFFER, gl.GenBuffers(1))
    gl.BufferData(gl.ARRAY_BUFFER, 36, { 0, 0, 0, 1, 0, 0, 0, 1, 0 }, gl.STATIC_DRAW)
    gl.EnableVertexAttribArray(0)
    gl.VertexAttribPointer(0, 3, gl.FLOAT, false, 1 << 20, 1 << 30)
    gl.DrawArrays(gl.TRIANGLES, 0, 3)
  end,
}
