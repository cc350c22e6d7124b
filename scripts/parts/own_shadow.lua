-- A side that is turned from the light is in its own shadow. Near the terminator the volume's sides
-- run so close along such faces that 24 bits of depth cannot tell them apart; which way a face is
-- turned is known exactly, so bit 7 of the stencil is set by that, and the volumes count in the rest.
return function(volumes, shader, seen)
  gl.StencilMask(0x80)
  gl.StencilFunc(gl.ALWAYS, 0x80, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.Enable(gl.CULL_FACE)
  gl.CullFace(gl.BACK)
  -- The same triangles as the scene's, so the same depths; two units for those that were turned or
  -- clipped, whose rounding may differ.
  gl.DepthFunc(gl.LEQUAL)
  gl.Enable(gl.POLYGON_OFFSET_FILL)
  gl.PolygonOffset(0, -2)
  for _, volume in ipairs(volumes) do volume:draw_unlit(shader, seen) end
  gl.Disable(gl.POLYGON_OFFSET_FILL)
  gl.DepthFunc(gl.LESS)
  gl.Disable(gl.CULL_FACE)
  gl.StencilMask(0x7F)
end
