-- Lab 09. Z-pass, as in lab 07: right as long as the eye is in the light. Reverse it. The places that have to
-- change are marked TO DO; README.md has the theory.
local recipe = {
  title   = "Lab 09: Carmack's reverse",
  lecture = "004_502e9deeb91da7bb: Carmack's reverse",
  scene   = "city",
  truth   = "hard",
  params  = { light = param.direction(-0.5, 0.55, -0.85), darkness = param.number(0.25, 0, 1) },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
end

function recipe.draw(r)
  local scene, camera, light, darkness = r.scene, r.scene.camera, r.params.light, r.params.darkness
  local view = camera:view()
  -- TO DO (1): caps at infinity must not be cut off by a far plane.
  local projection = camera:projection(r.width / r.height)
  local volumes = {}
  for k, caster in ipairs(scene.casters) do
    -- TO DO (2): a volume that is counted from behind has to be closed.
    volumes[k] = shadow.volume(caster, nil, light, { caps = false })
  end

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the z-buffer", function()
    gl.ColorMask(false, false, false, false)
    scene:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  pass("2. the volumes", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.DepthMask(false)
    gl.StencilFunc(gl.ALWAYS, 0, 0xFF)
    -- TO DO (3): count what is behind the scene, not what is in front of it. Which sides of the faces are
    -- +1 now, which -1? And volume:draw_sides draws no caps; volume:draw does.
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
    for _, volume in ipairs(volumes) do volume:draw_sides(r.volume, { view = view, projection = projection }) end
  end)

  gl.DepthMask(true)
  gl.ColorMask(true, true, true, true)
  gl.DepthFunc(gl.LEQUAL)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)

  pass("3. the dark part of the scene", function()
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = darkness })
  end)

  pass("4. the lit part of the scene", function()
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = darkness })
  end)
end

return recipe
