-- A fragment shader that never stops.
-- expect: timed out
-- says: look for a loop
-- job: 1 s
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nuniform float u = 1.0;\nvoid main() { float x = u; for (;;) { x = sin(x) + u; if (x < -5.0 * u) break; } color = vec4(x); }",
    }
    gl.BindFramebuffer(gl.FRAMEBUFFER, (fbo.color(2048, 2048)))
    gl.Viewport(0, 0, 2048, 2048)
    mesh.quad():draw(s)
  end,
}
