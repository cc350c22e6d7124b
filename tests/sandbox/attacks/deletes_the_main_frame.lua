-- Deletes what is not its own.
-- expect: recipe error
return {
  draw = function(r)
    gl.DeleteFramebuffers(1, 0)
    gl.BindFramebuffer(gl.FRAMEBUFFER, 1)
  end,
}
