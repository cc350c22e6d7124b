-- hint: Light and shadow are exchanged: 0 means that the ray is in no volume, which is lit. Pass 4 (dark) takes NOTEQUAL 0, pass 5 (lit) EQUAL 0.
-- hint.ca: La llum i l'ombra estan intercanviades: 0 vol dir que el raig no és dins de cap volum, i això és il·luminat. El pas 4 (fosc) demana NOTEQUAL 0; el 5 (clar), EQUAL 0.
-- hint.es: La luz y la sombra están intercambiadas: 0 quiere decir que el rayo no está en ningún volumen, y eso es iluminado. El paso 4 (oscuro) pide NOTEQUAL 0; el 5 (claro), EQUAL 0.
-- hint.fr: Lumière et ombre sont échangées : 0 veut dire que le rayon n'est dans aucun volume, c'est donc éclairé. La passe 4 (sombre) demande NOTEQUAL 0, la passe 5 (claire) EQUAL 0.

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

  pass("2. the volumes' front faces in the stencil", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.DepthMask(false)
    gl.StencilFunc(gl.ALWAYS, 0, 0)
    gl.Enable(gl.CULL_FACE)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.INCR)
    gl.CullFace(gl.BACK)
    draw_volumes()
  end)

  pass("3. their back faces", function()
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.DECR)
    gl.CullFace(gl.FRONT)
    draw_volumes()
  end)

  pass("4. the dark part of the scene", function()
    gl.DepthMask(true)
    gl.ColorMask(true, true, true, true)
    gl.Disable(gl.CULL_FACE)
    gl.DepthFunc(gl.LEQUAL)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = darkness })
  end)

  pass("5. the lit part of the scene", function()
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = darkness })
  end)

  pass("6. the initial state again", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
  end)
end

return recipe
