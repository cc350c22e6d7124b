-- Draws to a texture that it samples.
-- expect: finished or recipe error
return {
  draw = function(r)
    local target, texture = fbo.color(64, 64)
    gl.BindFramebuffer(gl.FRAMEBUFFER, target)
    gl.BindTexture(gl.TEXTURE_2D, texture)
    mesh.quad():draw(shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nuniform sampler2D t;\nout vec4 color;\nvoid main() { color = texelFetch(t, ivec2(gl_FragCoord) * 1000, 0); }",
    })
    gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, 64, 64)
    gl.BlitFramebuffer(0, 0, 64, 64, 1, 1, 65, 65, gl.COLOR_BUFFER_BIT, gl.NEAREST)
  end,
}
