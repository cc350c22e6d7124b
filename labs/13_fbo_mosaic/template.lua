-- Lab 13. The teapot is drawn into the window. Draw it into a framebuffer object instead, and copy that ten
-- times: fill in what is marked TO DO. README.md says which copy goes where.
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

  -- TO DO (1): a framebuffer object r.fbo with two renderbuffers of fbowidth × fboheight, one of colours and
  -- one of depths, attached where they belong. Is it complete?
end

function recipe.draw(r)
  local scene, camera, width, height = r.scene, r.scene.camera, r.width, r.height
  local fbowidth, fboheight = r.params.fbowidth, r.params.fboheight

  pass("1. the teapot, into the framebuffer object", function()
    -- TO DO (2): draw into it, all of it.
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    scene:draw(r.phong, { view = camera:view(), projection = camera:projection(fbowidth / fboheight),
                          light = r.params.light })
  end)

  pass("2. halves: upper left as it is, lower right turned", function()
    -- TO DO (3): read from the object, draw to the window. The whole of it to the upper left half, and to the
    -- lower right one with its corners exchanged; LINEAR.
  end)

  pass("3. quarters: lower left as they are, upper right turned", function()
    for i = 0, 1 do
      for j = 0, 1 do
        -- TO DO (4): quarter (i, j) of the lower left, and turned, of the upper right.
      end
    end
  end)
end

return recipe
