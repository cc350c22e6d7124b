-- A side that is turned from the light is in its own shadow. Near the terminator the volume's sides
-- run so close along such faces that 24 bits of depth cannot tell them apart; which way a face is
-- turned is known exactly, so bit 7 of the stencil is set by that, and the volumes count in the rest.
return function(volumes, shader, seen)
  gl.StencilMask(0x80)
  gl.StencilFunc(gl.ALWAYS, 0x80, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.DepthFunc(gl.LEQUAL)
  for _, volume in ipairs(volumes) do volume:draw_unlit(shader, seen) end
  gl.DepthFunc(gl.LESS)
  gl.StencilMask(0x7F)
end
