-- hint: Everything in front of a volume is dark as well: only its back faces are counted. Its hidden front faces must take 1 away again.
-- hint.ca: També és fosc tot el que hi ha davant d'un volum: només se'n compten les cares posteriors. Les cares anteriors amagades han de tornar a restar 1.
-- hint.es: También está oscuro todo lo que hay delante de un volumen: solo se cuentan sus caras traseras. Las caras delanteras ocultas deben volver a restar 1.
-- hint.fr: Tout ce qui est devant un volume est sombre aussi : seules ses faces arrière sont comptées. Ses faces avant cachées doivent retirer 1.

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
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local volumes = {}
  for k, caster in ipairs(scene.casters) do
    volumes[k] = shadow.volume(caster, nil, light, { caps = true })
  end

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the z-buffer", function()
    gl.ColorMask(false, false, false, false)
    scene:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  pass("2. the volumes behind the scene: back faces +1, front faces -1", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.DepthMask(false)
    gl.StencilFunc(gl.ALWAYS, 0, 0xFF)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.KEEP)
    for _, volume in ipairs(volumes) do volume:draw(r.volume, { view = view, projection = projection }) end
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
