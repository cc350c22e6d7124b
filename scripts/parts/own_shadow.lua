-- A side turned from the light is in its own shadow. Which way a face is turned is known exactly, where
-- depth could not tell it from the sides of its own volume, that run along it near the terminator: so bit
-- 7 of the stencil is set by that, and the volumes count in the rest, from 0. Comes after
-- scene_depth.draw, whose depths and stencil it needs; of all volumes, before any is counted. What is drawn
-- next is pushed back by the error of its depths (see parts.scene_depth).
return function(volumes, shader, seen)
  gl.StencilMask(0x80)
  gl.StencilFunc(gl.EQUAL, 0x81, 0x01)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.DepthFunc(gl.EQUAL)
  for _, volume in ipairs(volumes) do volume:draw_unlit(shader, seen) end
  gl.StencilMask(0x7F)
  gl.Clear(gl.STENCIL_BUFFER_BIT)
  gl.DepthFunc(gl.LESS)
  gl.PolygonOffset(1 / 512, 0)
end
