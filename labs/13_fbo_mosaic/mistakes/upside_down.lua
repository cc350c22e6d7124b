-- hint: Upper and lower halves are exchanged: y = 0 is the window's lower edge. The upper left half goes from height / 2 to height.
-- hint.ca: Les meitats superior i inferior estan intercanviades: y = 0 és la vora inferior de la finestra. La meitat superior esquerra va de height / 2 a height.
-- hint.es: Las mitades superior e inferior están intercambiadas: y = 0 es el borde inferior de la ventana. La mitad superior izquierda va de height / 2 a height.
-- hint.fr: Les moitiés haute et basse sont échangées : y = 0 est le bord inférieur de la fenêtre. La moitié en haut à gauche va de height / 2 à height.

local recipe = {
  title   = "Lab 13: a mosaic from a framebuffer object",
  lecture = "003_dcbdf1292070997a: Framebuffer objects, ej9-1",
  scene   = "teapot",
  params  = {
    light     = param.point(3, 4, 5),
    fbowidth  = param.integer(400, 16, 4096),
    fboheight = param.integer(300, 16, 4096),
  },
}

function recipe.setup(r)
  local fbowidth, fboheight = r.params.fbowidth, r.params.fboheight
  r.phong = shader.load "phong"

  r.fbo = gl.GenFramebuffers(1)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.fbo)
  local color, depth = gl.GenRenderbuffers(2)
  gl.BindRenderbuffer(gl.RENDERBUFFER, color)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.RGBA, fbowidth, fboheight)
  gl.BindRenderbuffer(gl.RENDERBUFFER, depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT, fbowidth, fboheight)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, color)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth)
  if gl.CheckFramebufferStatus(gl.DRAW_FRAMEBUFFER) ~= gl.FRAMEBUFFER_COMPLETE then
    error "the framebuffer is not complete"
  end
end

function recipe.draw(r)
  local scene, camera, width, height = r.scene, r.scene.camera, r.width, r.height
  local fbowidth, fboheight = r.params.fbowidth, r.params.fboheight

  pass("1. the teapot, into the framebuffer object", function()
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.fbo)
    gl.DrawBuffer(gl.COLOR_ATTACHMENT0)
    gl.Viewport(0, 0, fbowidth, fboheight)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    scene:draw(r.phong, { view = camera:view(), projection = camera:projection(fbowidth / fboheight),
                          light = r.params.light })
  end)

  pass("2. halves: upper left as it is, lower right turned", function()
    gl.BindFramebuffer(gl.READ_FRAMEBUFFER, r.fbo)
    gl.ReadBuffer(gl.COLOR_ATTACHMENT0)
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, 0)
    gl.DrawBuffer(gl.BACK_LEFT)
    gl.BlitFramebuffer(0, 0, fbowidth, fboheight, 0, 0, width // 2, height // 2,
                       gl.COLOR_BUFFER_BIT, gl.LINEAR)
    gl.BlitFramebuffer(fbowidth, fboheight, 0, 0, width // 2, height // 2, width, height,
                       gl.COLOR_BUFFER_BIT, gl.LINEAR)
  end)

  pass("3. quarters: lower left as they are, upper right turned", function()
    for i = 0, 1 do
      for j = 0, 1 do
        local x0, y0 = i * width // 4, j * height // 4
        local x1, y1 = (i + 1) * width // 4, (j + 1) * height // 4
        gl.BlitFramebuffer(0, 0, fbowidth, fboheight, x0, y0 + height // 2, x1, y1 + height // 2, gl.COLOR_BUFFER_BIT, gl.LINEAR)
        gl.BlitFramebuffer(fbowidth, fboheight, 0, 0, x0 + width // 2, y0,
                           x1 + width // 2, y1, gl.COLOR_BUFFER_BIT, gl.LINEAR)
      end
    end
  end)
end

return recipe
