-- Near the terminator a volume's sides run so close along the faces beside them that 24 bits of depth
-- cannot tell which of the two is in front. So that no face stands in its own volume's rounding:
--  - a side turned from the light is in its own shadow. Which way a face is turned is known exactly,
--    and bit 7 of the stencil is set by that; the volumes count in the rest;
--  - for a side turned to the light, the volumes are pushed back by the error of interpolated depths:
--    what is that close to a face counts as behind it. Two units for the rounding of the two depths;
--    of the slope 1/256, since the corners of both are moved by up to 1/512 of a pixel. On a face square to
--    the view a shadow then begins at most 4 z^2 / (near 2^24) metres late, at a distance of z.
-- Whoever draws the scene again turns POLYGON_OFFSET_FILL off.
return function(volumes, shader, seen)
  gl.Disable(gl.POLYGON_OFFSET_FILL)
  gl.StencilMask(0x80)
  gl.StencilFunc(gl.ALWAYS, 0x80, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.DepthFunc(gl.LEQUAL)
  for _, volume in ipairs(volumes) do volume:draw_unlit(shader, seen) end
  gl.DepthFunc(gl.LESS)
  gl.StencilMask(0x7F)
  gl.PolygonOffset(1 / 256, 2)
  gl.Enable(gl.POLYGON_OFFSET_FILL)
end
