-- hint: Right while the eye is in the light, and wrong in a house's shadow: this is z-pass, which counts from the eye on. Count where the depth test fails: the second of gl.StencilOp's operations.
-- hint.ca: Correcte mentre l'ull és a la llum, i equivocat a l'ombra d'una casa: això és z-pass, que compta a partir de l'ull. Compta on falla el depth test: la segona operació de gl.StencilOp.
-- hint.es: Correcto mientras el ojo está en la luz, y equivocado en la sombra de una casa: esto es z-pass, que cuenta a partir del ojo. Cuenta donde falla el test de profundidad: la segunda operación de gl.StencilOp.
-- hint.fr: Juste tant que l'œil est dans la lumière, et faux dans l'ombre d'une maison : c'est z-pass, qui compte à partir de l'œil. Compte là où le test de profondeur échoue : la deuxième opération de gl.StencilOp.

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
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
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
