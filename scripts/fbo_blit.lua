-- Off-screen drawing: the teapot is drawn once into a framebuffer object of its own, whose size no
-- window limits, and then copied ten times into the main frame by BlitFramebuffer, which scales, and
-- flips where a rectangle's corners are reversed.
local recipe = {
  title   = "A mosaic of blits",
  lecture = "003_dcbdf1292070997a: Framebuffer objects, ej9-1",
  scene   = "teapot",
  params  = {
    light  = param.point(3, 4, 5),
    filter = param.choice("LINEAR", "NEAREST"),
    flip   = param.choice("both", "horizontal", "vertical", "none"),
    halves = param.integer(2, 1, 8),           -- the object's sides, in halves of the window's
    names  = param.choice("bound", "named"),   -- the functions of GL 3.0, or those of 4.5
  },
}

-- The lecture's listing: objects are bound to a target, and the functions act on the target.
local function by_binding(r, width, height)
  local fbo = gl.GenFramebuffers(1)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, fbo)
  local color, depth = gl.GenRenderbuffers(2)
  gl.BindRenderbuffer(gl.RENDERBUFFER, color)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.RGBA, width, height)
  gl.BindRenderbuffer(gl.RENDERBUFFER, depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT, width, height)

  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, color)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth)
  return fbo, gl.CheckFramebufferStatus(gl.DRAW_FRAMEBUFFER), color, depth
end

-- The same in GL 4.5: each function names the object that it acts on, and nothing is bound.
-- CreateFramebuffers, not GenFramebuffers: a name that was never bound is no object yet.
local function by_name(r, width, height)
  local fbo = gl.CreateFramebuffers(1)
  local color, depth = gl.CreateRenderbuffers(2)
  gl.NamedRenderbufferStorage(color, gl.RGBA, width, height)
  gl.NamedRenderbufferStorage(depth, gl.DEPTH_COMPONENT, width, height)

  gl.NamedFramebufferRenderbuffer(fbo, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, color)
  gl.NamedFramebufferRenderbuffer(fbo, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth)
  return fbo, gl.CheckNamedFramebufferStatus(fbo, gl.DRAW_FRAMEBUFFER), color, depth
end

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.fbowidth = r.params.halves * r.width // 2
  r.fboheight = r.params.halves * r.height // 2
  local make = r.params.names == "named" and by_name or by_binding
  r.fbo, r.status, r.color, r.depth = make(r, r.fbowidth, r.fboheight)
  if r.status ~= gl.FRAMEBUFFER_COMPLETE then error "the framebuffer is not complete" end
end

function recipe.draw(r)
  local camera, width, height = r.scene.camera, r.width, r.height
  local fbowidth, fboheight = r.fbowidth, r.fboheight

  pass("1. the teapot, into the framebuffer object", function()
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.fbo)
    gl.DrawBuffer(gl.COLOR_ATTACHMENT0)
    gl.Viewport(0, 0, fbowidth, fboheight)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    r.scene:draw(r.phong, { view = camera:view(), projection = camera:projection(fbowidth / fboheight),
                            light = r.params.light })
  end)

  local filter = gl[r.params.filter]
  local x0, x1, y0, y1 = 0, fbowidth, 0, fboheight
  if r.params.flip == "both" or r.params.flip == "horizontal" then x0, x1 = x1, x0 end
  if r.params.flip == "both" or r.params.flip == "vertical" then y0, y1 = y1, y0 end

  -- The source rectangle goes to the destination rectangle, corner to corner.
  local blit
  if r.params.names == "named" then
    blit = function(sx0, sy0, sx1, sy1, dx0, dy0, dx1, dy1)
      gl.BlitNamedFramebuffer(r.fbo, 0, sx0, sy0, sx1, sy1, dx0, dy0, dx1, dy1,
                              gl.COLOR_BUFFER_BIT, filter)
    end
  else
    blit = function(sx0, sy0, sx1, sy1, dx0, dy0, dx1, dy1)
      gl.BlitFramebuffer(sx0, sy0, sx1, sy1, dx0, dy0, dx1, dy1, gl.COLOR_BUFFER_BIT, filter)
    end
  end

  pass("2. halves: upper left as it is, lower right flipped", function()
    if r.params.names == "named" then
      gl.NamedFramebufferReadBuffer(r.fbo, gl.COLOR_ATTACHMENT0)
    else
      gl.BindFramebuffer(gl.READ_FRAMEBUFFER, r.fbo)
      gl.ReadBuffer(gl.COLOR_ATTACHMENT0)
    end
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, 0)
    gl.DrawBuffer(gl.BACK_LEFT)
    gl.Viewport(0, 0, width, height)
    blit(0, 0, fbowidth, fboheight, 0, height // 2, width // 2, height)
    blit(x0, y0, x1, y1, width // 2, 0, width, height // 2)
  end)

  pass("3. quarters: lower left as they are, upper right flipped", function()
    for i = 0, 1 do
      for j = 0, 1 do
        blit(0, 0, fbowidth, fboheight, i * width // 4, j * height // 4,
             (i + 1) * width // 4, (j + 1) * height // 4)
        blit(x0, y0, x1, y1, i * width // 4 + width // 2, j * height // 4 + height // 2,
             (i + 1) * width // 4 + width // 2, (j + 1) * height // 4 + height // 2)
      end
    end
  end)
end

return recipe
