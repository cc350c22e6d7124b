-- Right in another way: back faces first; the counts then go below zero and wrap around.
local recipe = {
  title   = "Lab 07: shadow volumes in six passes",
  lecture = "000_178f3ee06912f876: Volums d'ombra (1/2, 2/2)",
  scene   = "table",
  truth   = "hard",
  params  = { light = param.point(2, 4, 1), darkness = param.number(0.25, 0, 1) },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
end

function recipe.draw(r)
  local scene, camera, light, darkness = r.scene, r.scene.camera, r.params.light, r.params.darkness
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local volumes = {}
  for k, caster in ipairs(scene.casters) do
    volumes[k] = shadow.volume(caster, nil, light, { caps = false })
  end
  local function draw_volumes()
    for _, volume in ipairs(volumes) do volume:draw_sides(r.volume, { view = view, projection = projection }) end
  end

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the z-buffer", function()
    gl.ColorMask(false, false, false, false)
    scene:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  pass("2. the volumes' back faces in the stencil", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.DepthMask(false)
    gl.StencilFunc(gl.ALWAYS, 0, 0)
    gl.Enable(gl.CULL_FACE)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.DECR_WRAP)
    gl.CullFace(gl.FRONT)
    draw_volumes()
  end)

  pass("3. their front faces", function()
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.INCR_WRAP)
    gl.CullFace(gl.BACK)
    draw_volumes()
  end)

  pass("4. the dark part of the scene", function()
    gl.DepthMask(true)
    gl.ColorMask(true, true, true, true)
    gl.Disable(gl.CULL_FACE)
    gl.DepthFunc(gl.LEQUAL)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)       -- the slide's EQUAL 1 forgets where two shadows meet
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = darkness })
  end)

  pass("5. the lit part of the scene", function()
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = darkness })
  end)

  pass("6. the initial state again", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
  end)
end

return recipe
