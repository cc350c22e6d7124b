-- The error of what has been counted so far, by its own halves: where the first half of the points and the
-- second see much the same, both see much what all of the light would. For points in a nested pattern.
local halves = {}
local blocks = 32  -- of pixels, along a side: so many numbers squared are read back

function halves.setup(r)
  r.halves = shader.load "halves"
  r.halves_frame = fbo.color(blocks, blocks, gl.R32F)
  r.before = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.before)
  gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.R32F, r.width, r.height)
end

-- Keeps what a framebuffer has counted.
function halves.keep(r, frame)
  gl.BindFramebuffer(gl.FRAMEBUFFER, frame)
  gl.BindTexture(gl.TEXTURE_2D, r.before)
  gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, r.width, r.height)
end

-- The estimated error over the picture, `counted` being the texture of all `points`, of which half were there
-- when it was kept. The main frame is bound afterwards.
function halves.error(r, counted, points)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.halves_frame)
  gl.Viewport(0, 0, blocks, blocks)
  gl.ActiveTexture(gl.TEXTURE1)
  gl.BindTexture(gl.TEXTURE_2D, r.before)
  gl.ActiveTexture(gl.TEXTURE0)
  gl.BindTexture(gl.TEXTURE_2D, counted)
  r.quad:draw(r.halves, { counted = 0, before = 1, points = points, side = math.ceil(math.max(r.width, r.height) / blocks) })
  local squares = 0
  for _, sum in ipairs(gl.ReadPixels(0, 0, blocks, blocks, gl.RED, gl.FLOAT)) do squares = squares + sum end
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  gl.Viewport(0, 0, r.width, r.height)
  return shadow.error_of_halves(math.sqrt(squares / (r.width * r.height)))
end

return halves
