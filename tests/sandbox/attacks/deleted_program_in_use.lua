-- Draws with a program that it deleted.
-- expect: finished or recipe error
return {
  draw = function(r)
    local vertex, fragment = gl.CreateShader(gl.VERTEX_SHADER), gl.CreateShader(gl.FRAGMENT_SHADER)
    gl.ShaderSource(vertex, "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID); }")
    gl.ShaderSource(fragment, "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }")
    local program = gl.CreateProgram()
    for _, s in ipairs { vertex, fragment } do gl.CompileShader(s) gl.AttachShader(program, s) gl.DeleteShader(s) end
    gl.LinkProgram(program)
    gl.UseProgram(program)
    gl.DeleteProgram(program)
    gl.BindVertexArray(gl.GenVertexArrays(1))
    gl.DrawArrays(gl.TRIANGLES, 0, 3)
  end,
}
