-- Leaves masks, tests, programs and buffers as bad as can be.
-- expect: finished
return {
  draw = function(r)
    gl.ColorMask(false, false, false, false)
    gl.DepthMask(false)
    gl.StencilMask(0)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.NEVER, 0, 0)
    gl.Enable(gl.SCISSOR_TEST)
    gl.Scissor(0, 0, 0, 0)
    gl.Viewport(0, 0, 0, 0)
    gl.DepthFunc(gl.NEVER)
    gl.Enable(gl.CULL_FACE)
    gl.CullFace(gl.FRONT_AND_BACK)
    gl.Enable(gl.BLEND)
    gl.BlendFunc(gl.ZERO, gl.ZERO)
    gl.PixelStorei(gl.PACK_ALIGNMENT, 8)
    fbo.accumulation "float32"
    gl.BindFramebuffer(gl.FRAMEBUFFER, (fbo.color(8, 8)))
    shader.load("phong"):use {}
  end,
}
