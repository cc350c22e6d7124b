-- A million framebuffers by one call.
-- expect: recipe error
return {
  draw = function(r)
    gl.GenFramebuffers(1000000)
  end,
}
