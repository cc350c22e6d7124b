-- A depth map of size × size, drawn from the light with the offset that its filter needs: what the
-- recipes shadow_map_copy and shadow_map_fbo write out, for those about something else.
local map_pass = {}

-- A depth texture in a framebuffer of its own, outside of which all is lit. With `compare`, lookups
-- compare; with `filter` gl.LINEAR the hardware does so for 2 × 2 texels.
function map_pass.make(size, compare, filter)
  local frame, map = fbo.depth(size, size)
  gl.BindTexture(gl.TEXTURE_2D, map)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  if compare then
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, compare)
  end
  if filter then
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter)
  end
  gl.BindTexture(gl.TEXTURE_2D, 0)
  return frame, map
end

-- The map that a frame reads, r.map in r.frame: made when somebody reads it for the first time (`read` is
-- what shadow.map_bias says). For a frame in which nobody does it is one texel, as far as can be: all is lit.
function map_pass.kept(r, read, ...)
  if read and not r.map then r.frame, r.map = map_pass.make(...) end
  if not read and not r.lit then
    local frame
    frame, r.lit = map_pass.make(1, select(2, ...))
    gl.BindFramebuffer(gl.FRAMEBUFFER, frame)
    gl.Clear(gl.DEPTH_BUFFER_BIT)
    gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  end
  return read and r.map or r.lit
end

-- Draws `what` (anything with draw) into it. `bias` is what shadow.map_bias gives, or nil for none.
function map_pass.draw(r, frame, size, what, shader, view, projection, bias)
  gl.BindFramebuffer(gl.FRAMEBUFFER, frame)
  gl.Viewport(0, 0, size, size)
  gl.Clear(gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  if bias then
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(bias.factor, bias.units)
  end
  what:draw(shader, { view = view, projection = projection })
  gl.Disable(gl.POLYGON_OFFSET_FILL)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  gl.Viewport(0, 0, r.width, r.height)
end

return map_pass
